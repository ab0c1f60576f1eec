#include "studies/radiosity/patch_matrix.hpp"

#include "core/radiosity/patch_factors.hpp"
#include "samplers/sampler.hpp"

namespace ff::studies {

std::optional<Eigen::MatrixXd> trace_patch_factors(const StudyPlan& plan, std::size_t index, std::uint64_t trial) {
    const Cell& cell = plan.cells[index];
    const Scene& scene = plan.scenes[cell.scene];
    const Method& method = plan.spec.methods[cell.method];
    if (method.estimator != Estimator::ray_shooting || cell.subdivision.m == 1) return std::nullopt;
    if (cell.subdivision.patches(scene) > most_traced_patches) return std::nullopt;
    const std::uint64_t count = points_per_sequence(method, cell.subdivision, cell.samples);
    const auto points = samplers::find(method.sampler).make({count, dimension(method.estimator), 0, 0});
    return shoot_patch_factors(scene, cell.subdivision, *make_tracer(scene, method.tracer), *points, cell.samples,
                               method.allocation, cell.key, static_cast<std::uint32_t>(trial));
}

}  // namespace ff::studies
