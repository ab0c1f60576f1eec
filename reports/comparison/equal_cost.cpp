#include "reports/comparison/equal_cost.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <string>

namespace ff::reports {
namespace {

using studies::Bout;
using studies::Equal;
using studies::RunComparison;

std::string size_of(const RunComparison& comparison, const Bout& bout, std::size_t side) {
    const studies::StudyPlan& plan = (side == 0 ? comparison.first : comparison.second).plan;
    return size_label(plan, plan.cells[bout.cells[side]]);
}

/// "3.1 [2.2, 4.6] times smaller MSE"
std::string ratio_in_words(const Bout& bout) {
    if (bout.is_exact) return "exact to rounding";
    return fmt::format(
        "{} times {}",
        bout.interval ? with_ends(bout.ratio, bout.interval->low, bout.interval->high) : brief(bout.ratio),
        bout.equal == Equal::error ? "fewer evaluations" : "smaller MSE");
}

/// The better method, or what it would take to show that it is: "not shown: rays (by 3.2 times the trials)"
std::string better_in_words(const RunComparison& comparison, const Bout& bout) {
    const std::string& name = comparison.names[bout.better];
    if (bout.is_shown) return name;
    if (!bout.times_trials) return fmt::format("not shown: {}", name);
    return fmt::format("not shown: {} ({} times the trials would)", name, brief(*bout.times_trials, 2));
}

}  // namespace

Table equal_cost_table(const RunComparison& comparison) {
    const studies::StudyPlan& plan = comparison.first.plan;
    Table table{"equal-cost",
                "At equal cost",
                fmt::format("The largest size of each method that a budget allows, repeated until it is used up: how "
                            "many times smaller the mean square error (MSE) of the better method is, and how many "
                            "times fewer evaluations it takes to an equal error. Intervals of a scene with the same "
                            "thing equal hold together with probability {:g} (Bonferroni). How many times the trials "
                            "would show what is not shown is found as if the ratio were as measured.",
                            comparison.level),
                {{"compared"},
                 {"pairs"},
                 {"better"},
                 {"by"},
                 {comparison.names[0], false, "size"},
                 {comparison.names[1], false, "size"}}};
    for (const Bout& bout : comparison.bouts) {
        if (!bout.is_main) continue;
        table.rows.push_back({scene_prefix(plan, bout.scene) + budget_label(bout.equal, bout.budget),
                              std::string(name(bout.pair_class)), better_in_words(comparison, bout),
                              ratio_in_words(bout), size_of(comparison, bout, 0), size_of(comparison, bout, 1)});
    }
    return table;
}

Json equal_cost_json(const RunComparison& comparison) {
    auto all = Json::array();
    for (const Bout& bout : comparison.bouts) {
        all.push_back({{"scene", comparison.first.plan.scenes.name(bout.scene)},
                       {"pairs", name(bout.pair_class)},
                       {"equal", studies::name(bout.equal)},
                       {"budget", bout.budget},
                       {"better", comparison.names[bout.better]},
                       {"is_shown", bout.is_shown},
                       {"is_exact", bout.is_exact},
                       {"ratio", bout.is_exact ? Json() : Json(bout.ratio)},
                       {"interval", interval_json(bout.interval)},
                       {"times_trials", optional_json(bout.times_trials)},
                       {"sizes", {size_of(comparison, bout, 0), size_of(comparison, bout, 1)}}});
    }
    return all;
}

}  // namespace ff::reports
