#include "app/terminal/progress.hpp"

#include "app/terminal/messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace ff::app {
namespace {

constexpr std::chrono::milliseconds pause_on_terminal{100};

std::string duration(double seconds) {
    const auto whole = std::lround(seconds);
    return whole < 100 ? fmt::format("{} s", whole) : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

std::string bar(double share) {
    constexpr int width = 30;
    const int full = static_cast<int>(share * width);
    std::string text;
    for (int i = 0; i < width; ++i) text += i < full ? "█" : "·";
    return text;
}

}  // namespace

ProgressDisplay::Style ProgressDisplay::style(bool quiet) {
    if (quiet) return Style::silent;
    return ::isatty(STDERR_FILENO) == 1 ? Style::bar : Style::lines;
}

void ProgressDisplay::show(const studies::Progress& progress) {
    if (style_ == Style::silent) return;
    const auto now = Clock::now();
    const bool last = progress.units_done == progress.units;
    const auto pause = style_ == Style::bar ? pause_on_terminal : std::chrono::milliseconds(10'000);
    if (already_done_ < 0) already_done_ = progress.expected_seconds_done;
    if (!last && now - last_ < pause) return;
    last_ = now;
    shown_ = true;

    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double share = progress.expected_seconds_done / progress.expected_seconds;
    const double done_here = progress.expected_seconds_done - already_done_;
    const double speed = done_here / std::max(elapsed, 1e-9);
    const std::string left =
        speed > 0 ? duration((progress.expected_seconds - progress.expected_seconds_done) / speed) : "?";
    const double rate = static_cast<double>(progress.evaluations) / std::max(elapsed, 1e-9) / 1e6;
    const std::string text = fmt::format("{:5.1f} %  {:.0f} M samples/s  {} left", 100 * share, rate, left);
    if (style_ == Style::bar) {
        say("\r{} {}   ", bar(share), text);
    } else {
        say("{}\n", text);
    }
    std::fflush(stderr);
}

bool FormFactorDisplay::is_seen() {
    return ::isatty(STDERR_FILENO) == 1;
}

void FormFactorDisplay::show(const studies::FormFactorProgress& progress) {
    const auto now = Clock::now();
    if (now - last_ < pause_on_terminal) return;
    last_ = now;
    shown_ = true;
    using Stage = studies::FormFactorProgress::Stage;
    const std::string stage = progress.stage == Stage::looking  ? "looking at pairs"
                              : progress.stage == Stage::pilots ? "pilot samples"
                                                                : fmt::format("round {}", progress.round);
    say("\r{} {:5.1f} % of {}  {:.1f} M samples  {} of {} pairs within {:g}   ", bar(progress.share),
        100 * progress.share, stage, static_cast<double>(progress.samples) / 1e6, progress.within, progress.pairs,
        tolerance_);
    std::fflush(stderr);
}

void FormFactorDisplay::finish() {
    if (shown_) say("\n");
}

void ProgressDisplay::finish() {
    if (style_ == Style::bar && shown_) say("\n");
}

}  // namespace ff::app
