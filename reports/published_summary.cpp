#include "reports/published_summary.hpp"

#include "reports/audit_markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {

std::string published_in_brief(const studies::PublishedResults& published) {
    std::size_t sampled = 0;
    std::string surprising;
    for (const studies::TableComparison& table : published.comparisons) {
        for (const studies::FigureComparison& c : table.figures) {
            if (!c.adjusted_p) continue;
            ++sampled;
            if (*c.adjusted_p >= 0.05) continue;
            const std::string z = c.z ? fmt::format(" (z = {:+.1f})", *c.z) : std::string(" (no trial gives it)");
            surprising += fmt::format("  {}: {}{}\n", studies::describe(published.tables, c.figure),
                                      published.tables.figures[c.figure].printed, z);
        }
    }
    std::string out =
        fmt::format("Published: {}\n{} sampled figures compared; outside what a run gives (5 % a table, Holm):\n{}",
                    published.tables.source, sampled, surprising.empty() ? "  none\n" : surprising);
    const auto count = [&](studies::ClaimVerdict verdict) {
        return std::count_if(published.claims.begin(), published.claims.end(),
                             [&](const auto& claim) { return claim.verdict == verdict; });
    };
    if (!published.claims.empty()) {
        out +=
            fmt::format("Claims: {} supported, {} refuted, {} inconclusive\n", count(studies::ClaimVerdict::supported),
                        count(studies::ClaimVerdict::refuted), count(studies::ClaimVerdict::inconclusive));
    }
    return out + audit_summary(published.tables, published.audit);
}

}  // namespace ff::reports
