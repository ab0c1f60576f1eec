#include "studies/plan/patch_systems.hpp"

#include "core/radiosity/patch_factors.hpp"
#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies {

bool tells_patches_apart(const StudyPlan& plan, std::size_t index) {
    const EstimatorInfo& estimator = estimator_info(plan.spec.methods[plan.cells[index].method]);
    const Scene& scene = plan.scenes[plan.cells[index].scene];
    return plan.cells[index].subdivision.patches(scene) > scene.surfaces.size() &&
           estimator.patch_factors != PatchFactors::none;
}

bool has_patch_systems(const StudyPlan& plan, std::size_t index) {
    return plan.spec.radiosity && plan.spec.radiosity->patch_trials > 0 && tells_patches_apart(plan, index);
}

std::uint64_t patch_trials(const StudyPlan& plan, std::size_t index) {
    return std::min(plan.cells[index].trials, plan.spec.radiosity->patch_trials);
}

void expect_few_patches(const StudyPlan& plan, std::size_t index) {
    const Cell& cell = plan.cells[index];
    const Method& method = plan.spec.methods[cell.method];
    const Scene& scene = plan.scenes[cell.scene];
    const std::uint32_t patches = radiating_patches(scene, cell.subdivision);
    const std::uint32_t most =
        estimator_info(method).patch_factors == PatchFactors::rays ? most_traced_patches : most_kernel_patches;
    if (!has_exact_patch_factors(scene)) {
        throw UserError(fmt::format(
            "[radiosity]: patch_trials in scene '{}' (patches have exact factors where all surfaces are parallelograms "
            "that nothing can stand between). Leave patch_trials out.",
            scene.name));
    }
    if (const auto* const added = samplers::find_added(method.sampler); added != nullptr && added->content().empty()) {
        throw UserError(
            fmt::format("[radiosity]: patch_trials with method '{}' (reports compute these trials again, and the store "
                        "does not hold what makes the points of {}). Leave patch_trials out.",
                        method.name, method.sampler));
    }
    if (patches <= most) return;
    throw UserError(fmt::format(
        "[radiosity]: patch_trials with method '{}' and {} patches in all (every pair has a factor: at most {} patches "
        "with {}). Take fewer patches per face, or leave patch_trials out.",
        method.name, patches, most, method.estimator));
}

}  // namespace ff::studies
