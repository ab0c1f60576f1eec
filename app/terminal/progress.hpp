#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/run/run.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace ff::app {

/// Shows the progress of a run on stderr: a bar that rewrites itself on a terminal, a line every ten seconds elsewhere.
class ProgressDisplay {
  public:
    enum class Style { silent, lines, bar };
    explicit ProgressDisplay(Style style) : style_(style) {}

    void show(const studies::RunProgress& progress);
    /// Leaves the bar's line.
    void finish();

    /// The style for this stderr.
    static Style style(bool quiet);

  private:
    using Clock = std::chrono::steady_clock;
    Style style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    double already_done_ = -1;  // expected seconds completed by an earlier run
    bool shown_ = false;
};

/// The same for counted items.
class CountDisplay {
  public:
    /// @param done_to  what happens to them: "pictures drawn"
    CountDisplay(ProgressDisplay::Style style, std::string done_to, std::size_t all)
        : style_(style), done_to_(std::move(done_to)), all_(all) {}

    void show(std::size_t done);
    /// Leaves the bar's line.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    ProgressDisplay::Style style_;
    std::string done_to_;
    std::size_t all_;
    Clock::time_point last_ = Clock::now();
    bool shown_ = false;
};

/// The same for a matrix of form factors, on a terminal only.
class FormFactorDisplay {
  public:
    explicit FormFactorDisplay(double tolerance) : tolerance_(tolerance) {}

    /// Whether stderr is a terminal.
    [[nodiscard]] static bool is_seen();
    void show(const studies::form_factors::Progress& progress);
    void finish() const;

  private:
    using Clock = std::chrono::steady_clock;
    double tolerance_;
    Clock::time_point last_{};
    bool shown_ = false;
};

}  // namespace ff::app
