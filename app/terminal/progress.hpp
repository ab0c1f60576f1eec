#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/run/run.hpp"

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace ff::app {

/// Shows the progress of work on stderr: a bar that rewrites itself on a terminal, a line every ten seconds elsewhere.
class ProgressDisplay {
  public:
    explicit ProgressDisplay(bool quiet);

    /// Whether stderr is a terminal, and shows something.
    [[nodiscard]] bool is_bar() const { return style_ == Style::bar; }
    void show(const studies::RunProgress& progress);
    /// Counted items. @param done_to  what happens to them: "pictures drawn"
    void show(std::size_t done, std::size_t all, std::string_view done_to);
    /// Pairs of a matrix of form factors.
    void show(const studies::form_factors::Progress& progress, double tolerance);
    /// Leaves the bar's line.
    void finish() const;

  private:
    using Clock = std::chrono::steady_clock;
    enum class Style { silent, lines, bar };
    /// Whether it is time to show something again.
    bool is_due();
    void show(double share, const std::string& text);

    Style style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool shown_ = false;
};

}  // namespace ff::app
