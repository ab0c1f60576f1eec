#include "reports/tables/tables.hpp"
#include "reports/text/idle_columns.hpp"
#include "reports/text/labels.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/diagnostics/claimed_errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

std::string_view in_words(studies::Claimant claimant) {
    switch (claimant) {
        case studies::Claimant::estimator:
            return "of the estimator";
        case studies::Claimant::study:
            return "claimed_error";
        case studies::Claimant::one_run:
            break;
    }
    return "rays taken as random";
}

/// The ratio is infinite where the claimed error is 0.
std::string times_claimed(double ratio) {
    return std::isfinite(ratio) ? fmt::format("{:.2g}", ratio) : "infinite";
}

}  // namespace

Table claimed_errors_table(const studies::StudyResults& results, Claims claims) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "claimed-errors",
        "How often claimed errors hold",
        fmt::format("Share of pairs and runs whose error is at most what is claimed; on the pair where it holds "
                    "least, of how many runs, with the interval of that share (Clopper-Pearson, {0:g} over "
                    "the pairs together). A claim about rays taken as random is {1:.3g} binomial standard "
                    "errors of one run, and should hold in a share of {0:g}; others always, or in the share that the "
                    "study says. Last, the median "
                    "and the largest error, in units of what is claimed (infinite "
                    "where that is 0).",
                    plan.spec.level, stats::normal_critical((1 - plan.spec.level) / 2)),
        {{"method and size", false, ""},
         {"pairs", false, ""},
         {"verdict", false, ""},
         {"holds", true, ""},
         {"should hold", true, "", true},
         {"claim", false, "", true},
         {"on the worst pair", false, "", true},
         {"errors / claim", false, "", true}},
        {},
        {}};
    std::vector<const studies::ClaimedErrors*> rows;
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        if (claims == Claims::all || row.claimant != studies::Claimant::one_run) rows.push_back(&row);
    }
    // Where many claims hold, it is enough to say how many.
    constexpr std::size_t most_rows = 12;
    std::size_t hidden = 0;
    if (claims == Claims::stated && rows.size() > most_rows)
        hidden =
            std::erase_if(rows, [](const auto* row) { return row->finding == studies::ClaimedErrorFinding::holds; });
    if (hidden > 0) {
        table.remarks.push_back(
            fmt::format("{} methods, sizes and classes of pairs whose claims hold: claimed_errors.csv.", hidden));
    }
    for (const studies::ClaimedErrors* const found : rows) {
        const studies::ClaimedErrors& row = *found;
        const studies::Cell& cell = plan.cells[row.cell];
        const std::uint64_t trials = cell.trials;
        const bool fails = row.finding == studies::ClaimedErrorFinding::fails;
        table.rows.push_back({{cell_label(plan, cell)},
                              {std::string(name(row.pair_class))},
                              {fails ? "fails" : "not refuted", fails ? Mark::bad : Mark::good},
                              {fmt::format("{:.4g} %", 100 * row.share())},
                              {row.promised < 1 ? fmt::format("{:.4g} %", 100 * row.promised) : "always"},
                              {std::string(in_words(row.claimant))},
                              {trials == 1 ? std::string("–")
                                           : fmt::format("{} of {} [{:.3f}, {:.3f}]", row.worst_held, trials,
                                                         row.worst_share_interval.low, row.worst_share_interval.high)},
                              {times_claimed(row.median_ratio) + ", " + times_claimed(row.largest_ratio)}});
    }
    return without_idle_columns(std::move(table));
}

}  // namespace ff::reports
