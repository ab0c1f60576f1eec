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

/// The verdict on each claim, for a publication that has claims in words only.
std::vector<std::string> claims_in_brief(const studies::PublishedResults& published) {
    std::vector<std::string> lines;
    for (const studies::JudgedClaim& judged : published.claims)
        lines.push_back(
            fmt::format("{}: “{}” {}", studies::name(judged.verdict), judged.claim.statement, judged.evidence));
    return lines;
}

}  // namespace

std::string claims_sentence(const studies::PublishedResults& published) {
    const auto count = [&](studies::ClaimVerdict verdict) {
        return std::count_if(published.claims.begin(), published.claims.end(),
                             [&](const auto& claim) { return claim.verdict == verdict; });
    };
    if (published.claims.size() == 1)
        return fmt::format("The publication's claim is {}.", studies::name(published.claims.front().verdict));
    const auto supported = count(studies::ClaimVerdict::supported);
    const auto printed_only = count(studies::ClaimVerdict::as_printed_only);
    return fmt::format(
        "Of the publication's {} claims {} {} supported, {}{} refuted, {} inconclusive.", published.claims.size(),
        supported, supported == 1 ? "is" : "are",
        printed_only == 0
            ? std::string()
            : fmt::format("{} only by printed figures that the methods as described do not give, ", printed_only),
        count(studies::ClaimVerdict::refuted), count(studies::ClaimVerdict::inconclusive));
}

std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha) {
    if (published.tables.figures.empty()) return claims_in_brief(published);
    std::vector<std::string> lines{surprising_figures(published, alpha)};
    if (!published.claims.empty()) lines.push_back(claims_sentence(published));
    return lines;
}

}  // namespace ff::reports
