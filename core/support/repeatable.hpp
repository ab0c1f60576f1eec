#pragma once

#include "core/support/processor_time.hpp"

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace ff {

/// What one run of outside code depends on besides sizes.
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

/// Sees to it, once and before its first result, that outside code keeps what trials rest on: two runs with one seed
/// agree, and another seed gives something else. A generator that all calls share does not repeat.
class Repeatable {
  public:
    Repeatable(bool randomised, OutsideWords words) : randomised_(randomised), words_(words) {}

    /// @param title   of the code, for messages   @param what  it gives, in the plural
    /// @param result  of a run, for the comparison
    /// @throws UserError; what `result` throws
    template <class Result>
    void expect(std::string_view title, std::string_view what, const Result& result) {
        std::call_once(checked_, [&] {
            const UncountedTime no_cost_of_trials;
            constexpr OutsideSeed seed{0x5eed0123456789ab, 0};
            constexpr OutsideSeed another{0x0123456789ab5eed, 1};
            const auto once = result(seed);
            if (once != result(seed)) refuse_unrepeatable(title, what);
            if (randomised_ && once == result(another)) refuse_seedless(title, what);
        });
    }

  private:
    [[noreturn]] void refuse_unrepeatable(std::string_view title, std::string_view what) const;
    [[noreturn]] void refuse_seedless(std::string_view title, std::string_view what) const;

    bool randomised_;
    OutsideWords words_;
    std::once_flag checked_;
};

}  // namespace ff
