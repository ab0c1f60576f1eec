#include "app/terminal/progress.hpp"

#include "app/terminal/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ff::app {
namespace {

constexpr std::chrono::milliseconds pause_on_terminal{100};
constexpr std::chrono::milliseconds pause_elsewhere{10'000};

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

ProgressDisplay::ProgressDisplay(bool quiet)
    : style_(quiet                          ? Style::silent
             : ::isatty(STDERR_FILENO) == 1 ? Style::bar
                                            : Style::lines) {}

bool ProgressDisplay::is_due() {
    const auto now = Clock::now();
    if (style_ == Style::silent || now - last_ < (is_bar() ? pause_on_terminal : pause_elsewhere)) return false;
    last_ = now;
    return true;
}

void ProgressDisplay::show(double share, const std::string& text) {
    shown_ = true;
    if (is_bar())
        rewrite_line(share, text);
    else
        say("{}\n", text);
}

void ProgressDisplay::show(const studies::RunProgress& progress) {
    const bool last = progress.units_done == progress.units;
    if (style_ == Style::silent || (!is_due() && !last)) return;
    const double elapsed = std::max(std::chrono::duration<double>(Clock::now() - start_).count(), 1e-9);
    const auto& seconds = progress.seconds;
    const double speed = (seconds.done - seconds.before) / elapsed;
    const std::string left = speed > 0 ? duration((seconds.all - seconds.done) / speed) : "?";
    const double share = seconds.done / seconds.all;
    show(share, fmt::format("{:5.1f} %  {:.0f} M samples/s  {} left", 100 * share,
                            static_cast<double>(progress.evaluations) / elapsed / 1e6, left));
}

void ProgressDisplay::show(std::size_t done, std::size_t all, std::string_view done_to) {
    if (!is_due()) return;
    show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} {}", done, all, done_to));
}

void ProgressDisplay::show(const studies::form_factors::Progress& progress, double tolerance) {
    if (!is_due() && shown_) return;  // the first at once
    using Stage = studies::form_factors::Progress::Stage;
    const std::string stage = progress.stage == Stage::looking  ? "looking at pairs"
                              : progress.stage == Stage::pilots ? "pilot samples"
                                                                : fmt::format("round {}", progress.round);
    show(progress.share,
         fmt::format("{:5.1f} % of {}  {:.1f} M samples  {} of {} pairs within {:g}", 100 * progress.share, stage,
                     static_cast<double>(progress.samples) / 1e6, progress.within, progress.pairs, tolerance));
}

void ProgressDisplay::finish() const {
    if (is_bar() && shown_) say("\n");
}

}  // namespace ff::app
