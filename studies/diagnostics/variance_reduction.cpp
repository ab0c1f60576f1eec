#include "studies/diagnostics/variance_reduction.hpp"

#include "samplers/sampler.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

/// The cell of random points that differs from this one in the sampler and the allocation of its points only.
std::optional<std::size_t> counterpart(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const auto found = std::find_if(plan.cells.begin(), plan.cells.end(), [&](const Cell& other) {
        const Method& candidate = plan.spec.methods[other.method];
        return candidate.sampler == samplers::yardstick().name && other.scene == cell.scene &&
               candidate.estimator == method.estimator && candidate.completion == method.completion &&
               other.subdivision.m == cell.subdivision.m && other.samples_per_patch == cell.samples_per_patch;
    });
    if (method.sampler == samplers::yardstick().name || found == plan.cells.end()) return std::nullopt;
    return static_cast<std::size_t>(found - plan.cells.begin());
}

}  // namespace

std::vector<VarianceReduction> compare_with_random(const Analysis& findings) {
    const StudyPlan& plan = findings.plan;
    std::vector<VarianceReduction> reductions;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const auto random = counterpart(plan, plan.cells[i]);
        if (plan.cells[i].deterministic || !random) continue;
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
            const ClassError* ours = findings.cells[i].class_error(pair_class);
            const ClassError* theirs = findings.cells[*random].class_error(pair_class);
            if (ours == nullptr || theirs == nullptr || !ours->squared_deviation || !theirs->squared_deviation)
                continue;
            const auto interval = ratio_interval(log_variance(*ours), log_variance(*theirs), plan.spec.level);
            if (!interval->is_finite() || interval->low == 0) continue;
            VarianceReduction& found = reductions.emplace_back();
            found.cell = i;
            found.random_cell = *random;
            found.pair_class = pair_class;
            found.factor = *theirs->variance / *ours->variance;
            found.interval = *interval;
        }
    }
    return reductions;
}

}  // namespace ff::studies
