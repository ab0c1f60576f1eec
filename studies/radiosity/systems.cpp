#include "studies/radiosity/systems.hpp"

#include "core/exact/known_factors.hpp"
#include "core/geometry/scene.hpp"
#include "core/patches/face_averages.hpp"
#include "core/patches/patch_order.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"
#include "studies/run/work.hpp"

#include <utility>

namespace ff::studies::radiosity {
namespace {

const RadiosityRequest& request_of(const StudyPlan& plan) {
    FF_EXPECT(plan.spec.radiosity.has_value());
    return *plan.spec.radiosity;
}

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
        trials.rays = static_cast<double>(estimates.samples_of_pair) * parts_a_surface(plan.scenes[cell.scene]);
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

Eigen::VectorXd for_faces(const std::vector<double>& numbers, Eigen::Index faces) {
    if (numbers.empty()) return Eigen::VectorXd::Unit(faces, faces - 1);
    if (numbers.size() == 1) return Eigen::VectorXd::Constant(faces, numbers.front());
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), faces);
}

Sight face_sight(const Scene& scene) {
    Sight sight = all_but_itself(static_cast<Eigen::Index>(scene.faces.size()));
    for (Eigen::Index face = 0; face < sight.rows(); ++face)
        sight(face, face) = sees_itself(scene, static_cast<int>(face));
    return sight;
}

RadiositySystem Lighting::system(std::size_t setting, Eigen::MatrixXd factors) const {
    return {std::move(factors), elements.areas, reflectance[setting], emission};
}

Lighting light_faces(const StudyPlan& plan, std::size_t scene) {
    const RadiosityRequest& request = request_of(plan);
    Lighting lighting;
    lighting.elements.areas = face_areas(plan.scenes[scene]);
    const Eigen::Index faces = lighting.elements.areas.size();
    lighting.elements.sight = face_sight(plan.scenes[scene]);
    lighting.exact = exact_room_factors(plan.scenes[scene]).value();
    for (const auto& setting : request.reflectance) lighting.reflectance.push_back(for_faces(setting, faces));
    lighting.emission = for_faces(request.emission, faces);
    return lighting;
}

PatchLight patch_light(const StudyPlan& plan, std::size_t scene_index, Subdivision subdivision) {
    const RadiosityRequest& request = request_of(plan);
    const Scene& scene = plan.scenes[scene_index];
    const auto spread = [&](const std::vector<double>& numbers) {
        const Eigen::VectorXd faces = for_faces(numbers, static_cast<Eigen::Index>(scene.faces.size()));
        const PatchOrder order(scene, subdivision, Numbered::of_faces);
        Eigen::VectorXd result(order.size());
        for (std::uint32_t patch = 0; patch < order.size(); ++patch)
            result[patch] = faces[scene.surfaces[order.place(patch).surface].face];
        return result;
    };
    PatchLight light{{}, spread(request.emission)};
    for (const auto& setting : request.reflectance) light.reflectance.push_back(spread(setting));
    return light;
}

Lighting light_patches(const StudyPlan& plan, std::size_t scene_index, Subdivision subdivision) {
    const Scene& scene = plan.scenes[scene_index];
    PatchLight light = patch_light(plan, scene_index, subdivision);
    return {{patch_areas(scene, subdivision), patch_sight(scene, subdivision)},
            exact_patch_factors(scene, subdivision).value(),
            std::move(light.reflectance),
            std::move(light.emission)};
}

SolverOptions solver_options(const StudyPlan& plan) {
    return {.tolerance = request_of(plan).tolerance};
}

}  // namespace ff::studies::radiosity
