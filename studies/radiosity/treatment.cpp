#include "studies/radiosity/treatment.hpp"

#include "core/patches/face_averages.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "studies/run/work.hpp"

#include <utility>

namespace ff::studies::radiosity {
namespace {

Eigen::MatrixXd by_reciprocity(const Eigen::MatrixXd& direct, const Eigen::VectorXd& areas) {
    Eigen::MatrixXd result = direct;
    for (Eigen::Index i = 0; i < direct.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) result(i, j) = direct(j, i) * (areas[j] / areas[i]);
    }
    return result;
}

Eigen::MatrixXd balanced(const Elements& elements, const Eigen::VectorXd& rays, const Eigen::MatrixXd& direct) {
    const Eigen::MatrixXd weights =
        rays.size() > 0 ? weights_of_hits(direct, rays, elements.areas, elements.sight) : weights_of_values(direct);
    const Balanced result = balance(direct.sparseView(), weights.sparseView(), elements.areas);
    return result.balanced ? Eigen::MatrixXd(result.factors) : Eigen::MatrixXd();
}

}  // namespace

std::string_view name(Treatment treatment) {
    static constexpr std::array<std::string_view, all_treatments.size()> names{"direct", "reciprocal", "normalised",
                                                                               "balanced"};
    return names.at(static_cast<std::size_t>(treatment));
}

Treatment treatment_of(Completion completion) {
    return completion == Completion::direct ? Treatment::direct : Treatment::reciprocal;
}

TrialMatrices load_matrices(const Store& store, std::size_t cell_index) {
    const StudyPlan& plan = store.plan();
    const Cell& cell = plan.cells[cell_index];
    const CellEstimates estimates = load_estimates(store, cell_index, Completion::direct);
    const auto faces = static_cast<Eigen::Index>(estimates.faces);
    TrialMatrices trials;
    trials.numbers = estimates.trial_numbers;
    if (estimator_info(plan.spec.methods[cell.method]).observes == Observes::hits)
        trials.rays = static_cast<double>(estimates.evaluations_per_face) * parts_a_surface(plan.scenes[cell.scene]);
    trials.direct.assign(estimates.trials(), Eigen::MatrixXd::Zero(faces, faces));
    for (Eigen::Index i = 0; i < faces; ++i) {
        for (Eigen::Index j = 0; j < faces; ++j) {
            const auto& values = estimates.factors[static_cast<std::size_t>(i * faces + j)];
            for (std::size_t trial = 0; trial < values.size(); ++trial) trials.direct[trial](i, j) = values[trial];
        }
    }
    return trials;
}

Eigen::MatrixXd trace_patch_factors(const StudyPlan& plan, std::size_t index, std::uint64_t trial,
                                    const std::atomic<bool>* stop) {
    FF_EXPECT(tells_patches_apart(plan, index));
    const Cell& cell = plan.cells[index];
    const Scene& scene = plan.scenes[cell.scene];
    const Method& method = plan.spec.methods[cell.method];
    const auto number = static_cast<std::uint32_t>(trial);
    const auto points = make_points(method, cell, stop);
    if (estimator_info(method).patch_factors == PatchFactors::kernels)
        return kernel_patch_factors(scene, cell.subdivision, *points, method.map, cell.key, number);
    return shoot_patch_factors(scene, cell.subdivision, *make_tracer(scene, method.tracer), *points,
                               cell.samples_per_patch, method.allocation, cell.key, number);
}

Eigen::MatrixXd treat(const Elements& elements, const Eigen::VectorXd& rays, const Eigen::MatrixXd& direct,
                      Treatment treatment) {
    switch (treatment) {
        case Treatment::direct:
            return direct;
        case Treatment::reciprocal:
            return by_reciprocity(direct, elements.areas);
        case Treatment::normalised:
            return normalise_rows(by_reciprocity(direct, elements.areas));
        case Treatment::balanced:
            break;
    }
    return balanced(elements, rays, direct);
}

}  // namespace ff::studies::radiosity
