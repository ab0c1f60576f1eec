#include "app/terminal/progress.hpp"

#include "app/terminal/messages.hpp"
#include "app/terminal/terminal_style.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace ff::app {
namespace {

constexpr std::chrono::milliseconds pause_on_terminal{100};
constexpr std::chrono::seconds pause_elsewhere{10};

std::chrono::milliseconds pause_of(ProgressDisplay::Style style) {
    return style == ProgressDisplay::Style::bar ? pause_on_terminal : pause_elsewhere;
}

std::string duration(double seconds) {
    const auto whole = std::lround(seconds);
    return whole < 100 ? fmt::format("{} s", whole) : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

/// Replaces the line of the terminal by a bar, as long as there is room, and a text.
void rewrite_line(double share, const std::string& text) {
    constexpr std::size_t longest = 30;
    const std::size_t room = width_of(STDERR_FILENO) - 1;  // the last column stays free: terminals differ there
    const std::size_t width = std::min(longest, room - std::min(room, text.size() + 1));
    const auto full = static_cast<std::size_t>(share * static_cast<double>(width));
    std::string bar;
    for (std::size_t i = 0; i < width; ++i) bar += i < full ? "█" : "·";
    if (width > 0) bar += ' ';
    say("\r{}{}\033[K", bar, text.substr(0, room));
    std::fflush(stderr);
}

}  // namespace

ProgressDisplay::Style ProgressDisplay::style(bool quiet) {
    if (quiet) return Style::silent;
    return ::isatty(STDERR_FILENO) == 1 ? Style::bar : Style::lines;
}

void ProgressDisplay::show(const studies::RunProgress& progress) {
    if (style_ == Style::silent) return;
    const auto now = Clock::now();
    const bool last = progress.units_done == progress.units;
    if (already_done_ < 0) already_done_ = progress.expected_seconds_done;
    if (!last && now - last_ < pause_of(style_)) return;
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
        rewrite_line(share, text);
    } else {
        say("{}\n", text);
    }
}

void CountDisplay::show(std::size_t done) {
    if (style_ == ProgressDisplay::Style::silent) return;
    const auto now = Clock::now();
    if (now - last_ < pause_of(style_)) return;
    last_ = now;
    shown_ = true;
    const std::string text = fmt::format("{} of {} {}", done, all_, done_to_);
    if (style_ == ProgressDisplay::Style::bar)
        rewrite_line(static_cast<double>(done) / static_cast<double>(all_), text);
    else
        say("{}\n", text);
}

void CountDisplay::finish() {
    if (style_ == ProgressDisplay::Style::bar && shown_) say("\n");
}

bool FormFactorDisplay::is_seen() {
    return ::isatty(STDERR_FILENO) == 1;
}

void FormFactorDisplay::show(const studies::form_factors::Progress& progress) {
    const auto now = Clock::now();
    if (now - last_ < pause_on_terminal) return;
    last_ = now;
    shown_ = true;
    using Stage = studies::form_factors::Progress::Stage;
    const std::string stage = progress.stage == Stage::looking  ? "looking at pairs"
                              : progress.stage == Stage::pilots ? "pilot samples"
                                                                : fmt::format("round {}", progress.round);
    rewrite_line(progress.share, fmt::format("{:5.1f} % of {}  {:.1f} M samples  {} of {} pairs within {:g}",
                                             100 * progress.share, stage, static_cast<double>(progress.samples) / 1e6,
                                             progress.within, progress.pairs, tolerance_));
}

void FormFactorDisplay::finish() const {
    if (shown_) say("\n");
}

void ProgressDisplay::finish() {
    if (style_ == Style::bar && shown_) say("\n");
}

}  // namespace ff::app
