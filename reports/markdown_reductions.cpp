#include "reports/labels.hpp"
#include "reports/markdown_sections.hpp"
#include "reports/reduction_words.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string reductions_section(const studies::StudyResults& results) {
    if (results.reductions.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## Variance against random points\n\n"
        "How many times less variance than the method with sampler `random` and the same scene, estimator, completion "
        "and size, on the pairs of a class together; intervals of level {:g} allow for the spread of both over trials. "
        "As many points for both: the factor is also that of the efficiency per point.\n\n"
        "| method | allocation | size | pairs | times less variance |\n|---|---|---|---|--:|\n",
        plan.spec.level);
    for (const studies::VarianceReduction& reduction : results.reductions) {
        const studies::Cell& cell = plan.cells[reduction.cell];
        const studies::Method& method = plan.spec.methods[cell.method];
        const bool shoots = method.estimator == studies::Estimator::ray_shooting;
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + ": ";
        out += fmt::format("| {}{} | {} | {} | {} | {} |\n", scene, method.name,
                           shoots ? studies::name(method.allocation) : "–", size_label(plan, cell),
                           name(reduction.pair_class), factor_text(reduction));
    }
    return out + "\n";
}

}  // namespace ff::reports
