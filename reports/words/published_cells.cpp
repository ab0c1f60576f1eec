#include "reports/words/published_cells.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::reports {

using studies::FigureComparison;

namespace {

std::string percentile_text(const stats::Rank& rank) {
    const double percentile = 100 * rank.percentile;
    const double step = 100.0 / static_cast<double>(rank.n);
    if (percentile < step) return fmt::format("below {:.2g} %", step);
    if (percentile > 100 - step) return fmt::format("above {:.4g} %", 100 - step);
    return fmt::format("{:.3g} %", percentile);
}

}  // namespace

std::string ours_text(const FigureComparison& c, const std::string& printed) {
    if (!c.ours) return "–";
    const double unit = studies::half_printed_unit(printed);
    if (c.deterministic || !c.single_run) return to_error(*c.ours, 20 * unit);
    const double spread = c.single_run->high - c.single_run->low;
    if (spread == 0) return fmt::format("{:g} always", *c.ours);
    return fmt::format("{} [{}, {}]", to_error(*c.ours, spread / 20), to_error(c.single_run->low, spread / 5),
                       to_error(c.single_run->high, spread / 5));
}

std::string place_text(const FigureComparison& c, const std::string& printed) {
    if (!c.ours) return "–";
    if (c.deterministic) {
        const double difference = c.printed - *c.ours;
        return std::abs(difference) <= 2 * studies::half_printed_unit(printed)
                   ? "equal"
                   : fmt::format("off by {:+.3g}", difference);
    }
    if (c.single_run->low == c.single_run->high) return *c.adjusted_p > 0 ? "equal" : "impossible";
    return c.z ? fmt::format("z {:+.2f}, {}", *c.z, percentile_text(*c.rank)) : percentile_text(*c.rank);
}

bool is_surprising(const FigureComparison& c, double alpha) {
    return c.ours && c.adjusted_p && *c.adjusted_p < alpha;
}

std::set<std::size_t> blamed_figures(const studies::audit::Report& audit) {
    std::set<std::size_t> blamed;
    for (const studies::audit::Finding& finding : audit.findings) {
        if (finding.severity == studies::audit::Severity::contradiction)
            blamed.insert(finding.blamed.begin(), finding.blamed.end());
    }
    return blamed;
}

}  // namespace ff::reports
