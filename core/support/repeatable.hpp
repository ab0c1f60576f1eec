#pragma once

#include "core/support/processor_time.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string_view>

namespace ff {

/// The seed and trial that one run of outside code depends on besides sizes.
struct OutsideSeed {
    std::uint64_t seed = 0;
    std::uint32_t trial = 0;
};

/// How messages speak of a kind of outside code.
struct OutsideWords {
    std::string_view gives;    ///< "prints", "returns"
    std::string_view seed;     ///< "{seed}", "seed"
    std::string_view no_seed;  ///< what to do where nothing is random
};

/// Says that equal results always show that seeds are ignored.
inline constexpr auto always_telling = [](const auto& /*result*/) { return true; };

/// Checks once, before the first result of outside code, what trials rest on: two runs with the same seed agree, other
/// seeds give other results, and code that answers many requests gives the same results after a new start, in another
/// order. A generator that all calls share does not repeat.
class Repeatable {
  public:
    Repeatable(bool randomised, OutsideWords words) : randomised_(randomised), words_(words) {}

    /// @param title   title of the code, for messages   @param what  name of its results, in the plural
    /// @param result  returns the result of a run with the seed of a trial, from 0
    /// @param telling  whether equal results for many seeds show that the code ignores them: rare events may not happen
    /// for any
    /// @param restart  makes code that remembers earlier requests forget them; empty where each run is a new start
    /// @throws UserError; what `result` throws
    template <class Result, class Telling>
    void expect(std::string_view title, std::string_view what, const Result& result, const Telling& telling,
                const std::function<void()>& restart = {}) {
        // Not std::call_once: threads that wait for one that throws wait for ever under ThreadSanitizer.
        if (checked_) return;
        const std::lock_guard lock(checking_);
        if (checked_) return;
        check(title, what, result, telling, restart);
        checked_ = true;
    }

  private:
    template <class Result, class Telling>
    void check(std::string_view title, std::string_view what, const Result& result, const Telling& telling,
               const std::function<void()>& restart) const {
        const UncountedTime no_cost_of_trials;
        constexpr std::uint32_t other_seeds = 9;  // the first that differs is the last
        const auto first = result(0u);
        if (first != result(0u)) refuse_unrepeatable(title, "run twice", what);
        if (!randomised_) return;
        std::uint32_t trial = 1;
        auto other = result(trial);
        while (first == other && telling(first) && trial < other_seeds) other = result(++trial);
        if (first == other && telling(first)) refuse_seedless(title, what);
        if (!restart) return;
        restart();
        if (other != result(trial) || first != result(0u)) refuse_unrepeatable(title, "started again", what);
    }

    [[noreturn]] void refuse_unrepeatable(std::string_view title, std::string_view when, std::string_view what) const;
    [[noreturn]] void refuse_seedless(std::string_view title, std::string_view what) const;

    bool randomised_;
    OutsideWords words_;
    std::mutex checking_;
    std::atomic<bool> checked_ = false;
};

}  // namespace ff
