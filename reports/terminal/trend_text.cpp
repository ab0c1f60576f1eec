#include "reports/terminal/trend_text.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ff::reports {
namespace {

/// The last runs, each as a bar between the least value and the largest.
std::string bars_of(const std::vector<double>& values) {
    static constexpr std::array<std::string_view, 8> bars{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr std::size_t most = 40;
    const std::size_t begin = values.size() > most ? values.size() - most : 0;
    const auto [least, largest] =
        std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin), values.end());
    const double width = *largest > *least ? *largest - *least : 1;
    std::string text;
    for (std::size_t i = begin; i < values.size(); ++i)
        text += bars.at(std::min<std::size_t>(7, static_cast<std::size_t>((values[i] - *least) / width * 8)));
    return text;
}

}  // namespace

std::string trend_in_words(const studies::Trend& trend) {
    if (!trend.change) return trend.note;
    if (!trend.changed) return fmt::format("no change found, {} (Holm)", p_text(trend.adjusted_p));
    const double before = trend.change->before;
    const double share = before != 0 ? 100 * (trend.change->after - before) / std::abs(before) : 0;
    return fmt::format("from {} on {} instead of {}{}, {} (Holm)", trend.commits[trend.change->first],
                       brief(trend.change->after, 6), brief(before, 6),
                       before != 0 ? fmt::format(" ({:+.3g} %)", share) : "", p_text(trend.adjusted_p));
}

std::string trend_text(const std::vector<studies::Trend>& trends, double alpha) {
    std::string text;
    std::size_t changed = 0;
    std::size_t untested = 0;
    for (const studies::Trend& trend : trends) {
        changed += trend.changed ? 1u : 0u;
        untested += trend.change ? 0u : 1u;
        text += fmt::format("{:<9}  {:<20}  {:<6}  {}  {}\n",
                            trend.changed  ? "changed"
                            : trend.change ? "steady"
                                           : "untested",
                            trend.quantity, name(trend.what), bars_of(trend.values), trend_in_words(trend));
    }
    return text + fmt::format("\n{} series: {} changed, {} untested; a false alarm in at most {} of histories.\n",
                              trends.size(), changed, untested, brief(alpha));
}

}  // namespace ff::reports
