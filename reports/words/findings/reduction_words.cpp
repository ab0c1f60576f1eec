#include "reports/words/findings/reduction_words.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/standing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

using studies::VarianceReduction;

/// The size without the scene's or the method's name: two cells of one size are compared.
std::string scene_and_size(const studies::StudyPlan& plan, const studies::Cell& cell) {
    const std::string size = size_label(plan, cell);
    return plan.scenes.size() == 1 ? size : fmt::format("{}, {}", plan.scenes[cell.scene].name, size);
}

const studies::Method& method_of(const studies::StudyPlan& plan, const VarianceReduction& reduction) {
    return plan.spec.methods[plan.cells[reduction.cell].method];
}

/// Beside each method with one sequence a face, the one that differs from it in this only.
const VarianceReduction* with_a_sequence_a_patch(const studies::StudyResults& results, const VarianceReduction& face) {
    const studies::StudyPlan& plan = results.findings.plan;
    const studies::Method& method = method_of(plan, face);
    if (method.allocation != Allocation::face) return nullptr;
    const auto found =
        std::find_if(results.reductions.begin(), results.reductions.end(), [&](const VarianceReduction& r) {
            const studies::Method& other = method_of(plan, r);
            return r.random_cell == face.random_cell && r.pair_class == face.pair_class &&
                   other.sampler == method.sampler && other.allocation == Allocation::patch;
        });
    return found == results.reductions.end() ? nullptr : &*found;
}

/// Whether a larger size of the same ladder says the same again.
bool is_below_the_top(const studies::StudyResults& results, std::size_t cell) {
    return std::any_of(results.slopes.begin(), results.slopes.end(), [&](const studies::LadderSlopes& ladder) {
        const auto& cells = ladder.ladder.cells;
        return cells.back() != cell && std::find(cells.begin(), cells.end(), cell) != cells.end();
    });
}

}  // namespace

std::string factor_text(const VarianceReduction& reduction) {
    return with_ends(reduction.factor, reduction.interval.low, reduction.interval.high);
}

std::vector<std::string> reductions_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> lines;
    if (!results.occlusion.empty()) return lines;  // its scenes differ in what hides, and are told together
    for (const Ranking& ranking : rank_variances(results)) {
        if (!is_below_the_top(results, *ranking.random_cell)) lines.push_back(sentence(ranking, plan));
    }
    for (const VarianceReduction& face : results.reductions) {
        const VarianceReduction* patch = with_a_sequence_a_patch(results, face);
        if (patch == nullptr || plan.cells[face.cell].subdivision.m == 1) continue;
        const double gain = face.factor / patch->factor;
        const bool apart = face.interval.low > patch->interval.high || face.interval.high < patch->interval.low;
        lines.push_back(fmt::format(
            "One {} sequence over all patches of a face instead of one per patch {} the variance on {} pairs "
            "by {:.2f} at {}{}.",
            method_of(plan, face).sampler, gain >= 1 ? "divides" : "multiplies", name(face.pair_class),
            gain >= 1 ? gain : 1 / gain, scene_and_size(plan, plan.cells[face.cell]),
            apart ? "" : " (intervals overlap)"));
    }
    return lines;
}

}  // namespace ff::reports
