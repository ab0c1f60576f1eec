#pragma once

#include "studies/form_factors/request.hpp"
#include "studies/run/run.hpp"

#include <chrono>
#include <cstdint>

namespace ff::app {

/// Shows how far a run is, on stderr: a bar that rewrites itself on a terminal, a line every ten seconds elsewhere.
class ProgressDisplay {
  public:
    enum class Style { silent, lines, bar };
    explicit ProgressDisplay(Style style) : style_(style) {}

    void show(const studies::Progress& progress);
    /// Leaves the bar's line.
    void finish();

    /// The style for this stderr.
    static Style style(bool quiet);

  private:
    using Clock = std::chrono::steady_clock;
    Style style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    double already_done_ = -1;  // expected seconds that an earlier run did
    bool shown_ = false;
};

/// The same for a matrix of form factors, on a terminal only.
class FormFactorDisplay {
  public:
    explicit FormFactorDisplay(double tolerance) : tolerance_(tolerance) {}

    /// Whether stderr is a terminal.
    [[nodiscard]] static bool is_seen();
    void show(const studies::FormFactorProgress& progress);
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    double tolerance_;
    Clock::time_point last_{};
    bool shown_ = false;
};

}  // namespace ff::app
