#include "reports/words/published_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

std::string surprising_figures(const studies::PublishedResults& published, double alpha) {
    std::size_t sampled = 0;
    std::vector<std::string> surprising;
    for (const studies::TableComparison& table : published.comparisons) {
        for (const studies::FigureComparison& c : table.figures) {
            if (!c.adjusted_p) continue;
            ++sampled;
            if (*c.adjusted_p >= alpha) continue;
            const std::string place = c.z ? fmt::format("z = {:+.1f}", *c.z) : std::string("no run gives it");
            surprising.push_back(fmt::format("{} = {} ({})", studies::describe(published.tables, c.figure),
                                             published.tables.figures[c.figure].printed, place));
        }
    }
    std::string text = fmt::format(
        "Of {} printed figures of sampled methods, {} lie outside what a run as described gives ({:g} % a table, Holm)",
        sampled, surprising.size(), 100 * alpha);
    return surprising.empty() ? text : fmt::format("{}: {}", text, fmt::join(surprising, "; "));
}

}  // namespace

std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha) {
    std::vector<std::string> lines{surprising_figures(published, alpha)};
    const auto count = [&](studies::ClaimVerdict verdict) {
        return std::count_if(published.claims.begin(), published.claims.end(),
                             [&](const auto& claim) { return claim.verdict == verdict; });
    };
    if (!published.claims.empty()) {
        const auto printed_only = count(studies::ClaimVerdict::as_printed_only);
        lines.push_back(fmt::format(
            "Of the publication's {} claims {} are supported, {}{} refuted, {} inconclusive.", published.claims.size(),
            count(studies::ClaimVerdict::supported),
            printed_only == 0
                ? std::string()
                : fmt::format("{} only by printed figures that the methods as described do not give, ", printed_only),
            count(studies::ClaimVerdict::refuted), count(studies::ClaimVerdict::inconclusive)));
    }
    return lines;
}

}  // namespace ff::reports
