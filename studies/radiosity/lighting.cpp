#include "studies/radiosity/lighting.hpp"

#include "core/exact/exact_rooms.hpp"
#include "core/patches/patch_order.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"

#include <utility>

namespace ff::studies::radiosity {
namespace {

const RadiosityRequest& request_of(const StudyPlan& plan) {
    FF_EXPECT(plan.spec.radiosity.has_value());
    return *plan.spec.radiosity;
}

/// One number for each face.
Eigen::VectorXd for_faces(const std::vector<double>& numbers, Eigen::Index faces) {
    if (numbers.empty()) return Eigen::VectorXd::Unit(faces, faces - 1);
    if (numbers.size() == 1) return Eigen::VectorXd::Constant(faces, numbers.front());
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), faces);
}

}  // namespace

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
