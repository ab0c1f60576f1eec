#include "reports/words/findings/left_out.hpp"

#include "studies/comparison/rivals.hpp"

#include <algorithm>
#include <set>

namespace ff::reports {

std::string which_variances_are_left_out(const studies::Analysis& findings, std::size_t scene) {
    const bool some =
        std::any_of(findings.cells.begin(), findings.cells.end(), [&](const studies::CellAnalysis& found) {
            return findings.plan.cells[found.cell].scene == scene &&
                   std::any_of(
                       found.class_errors.begin(), found.class_errors.end(),
                       [&](const studies::ClassError& error) { return found.has_infinite_variance(error.pair_class); });
        });
    return some ? "Infinite variances are not compared." : "";
}

std::string which_errors_are_left_out(const studies::Analysis& findings, const Ranking& ranking) {
    if (std::string some = which_variances_are_left_out(findings, ranking.scene); !some.empty()) return some;
    const studies::StudyPlan& plan = findings.plan;
    std::set<std::size_t> left_out;
    for (const studies::CellAnalysis& found : findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        if (cell.scene != ranking.scene || found.class_error(ranking.pair_class) == nullptr) continue;
        if (studies::estimator_info(plan.spec.methods[cell.method]).exact || studies::may_be_luck(plan, cell)) continue;
        left_out.insert(cell.method);
    }
    for (const RankedMethod& method : ranking.methods) left_out.erase(method.method);
    return left_out.empty() ? "" : "Methods without a common size are not compared.";
}

}  // namespace ff::reports
