#include "reports/tables/tables.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

TableCell answer(const stats::Interval& interval) {
    if (interval.low > 0) return {"yes", Mark::good};
    if (interval.high < 0) return {"the other way round", Mark::bad};
    return {"not shown", Mark::open};
}

}  // namespace

Table evenness_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "evenness",
        "Do measures of evenness predict the errors?",
        fmt::format("Kendall's rank correlation, over samplers of equal size, of a measure of how unevenly a "
                    "set of points is spread (mean of a few sets) and the RMSE that it makes; with its "
                    "interval of level {:g} [kendall1970]. 1: the same order. Samplers are not a random sample, "
                    "and errors are measured with noise, which lowers the correlation.",
                    plan.spec.level),
        {{"scene", false, "", true},
         {"samples", true, ""},
         {"pairs", false, ""},
         {"measure", false, ""},
         {"samplers", true, "", true},
         {"correlation", true, ""},
         {"interval", true, "", true},
         {"predicts the order", false, ""}},
        {},
        {}};
    for (const studies::Evenness& found : results.evenness) {
        const studies::Cell& cell = plan.cells[found.cell];
        const auto& [tau, interval] = found.correlation;
        table.rows.push_back(
            {{fmt::format("{}, {}", plan.scenes[cell.scene].name, plan.spec.methods[cell.method].estimator)},
             {fmt::format("{}", cell.samples_per_patch)},
             {std::string(name(found.pair_class))},
             {std::string(found.measure)},
             {fmt::format("{}", found.methods)},
             {fmt::format("{:.2f}", tau)},
             {fmt::format("[{:.2f}, {:.2f}]", interval.low, interval.high)},
             answer(interval)});
    }
    return table;
}

}  // namespace ff::reports
