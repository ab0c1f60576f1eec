#include "studies/radiosity/patch_matrix.hpp"

#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "studies/run/interruptible_points.hpp"
#include "studies/run/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::studies::radiosity {

Eigen::MatrixXd trace_patch_factors(const StudyPlan& plan, std::size_t index, std::uint64_t trial,
                                    const std::atomic<bool>* stop) {
    FF_EXPECT(tells_patches_apart(plan, index));
    const Cell& cell = plan.cells[index];
    const Scene& scene = plan.scenes[cell.scene];
    const Method& method = plan.spec.methods[cell.method];
    const auto number = static_cast<std::uint32_t>(trial);
    auto points = make_points(method, cell);
    if (stop != nullptr) points = interruptible(std::move(points), *stop);
    if (estimator_info(method).patch_factors == PatchFactors::kernels)
        return kernel_patch_factors(scene, cell.subdivision, *points, method.map, cell.key, number);
    return shoot_patch_factors(scene, cell.subdivision, *make_tracer(scene, method.tracer), *points,
                               cell.samples_per_patch, method.allocation, cell.key, number);
}

}  // namespace ff::studies::radiosity
