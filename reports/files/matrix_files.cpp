#include "reports/files/matrix_files.hpp"

#include "core/exact/known_factors.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/radiosity/system.hpp"
#include "core/support/error.hpp"
#include "reports/files/array_files.hpp"
#include "reports/text/labels.hpp"
#include "studies/radiosity/systems.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::reports {
namespace {

/// Most patches of a scene that a matrix is written for: as text it has 100 MB then.
constexpr std::uint32_t most_patches = 2000;

/// Where the matrices of a cell, or of the exact factors, go.
struct MatrixPlace {
    const TakeMatrix& take;
    std::string folder;
    std::string label;  ///< end of every comment

    void put(const std::string& name, const Eigen::MatrixXd& matrix, std::string_view what) const {
        take(folder + name, matrix, fmt::format("{}, {}", what, label));
    }
};

MatrixPlace place_of_cell(const TakeMatrix& take, const studies::StudyPlan& plan, std::size_t index,
                          std::uint64_t trial) {
    const studies::Cell& cell = plan.cells[index];
    return {take, fmt::format("cell_{}/", index),
            fmt::format("{}: {}, trial {}", plan.scenes.name(cell.scene), cell_label(plan, cell), trial)};
}

void put_system(const MatrixPlace& place, const studies::StudyPlan& plan, std::size_t scene,
                const Eigen::MatrixXd& factors) {
    place.put("form_factors", factors, "form factors");
    if (!plan.spec.radiosity) return;
    const studies::radiosity::Lighting lighting = studies::radiosity::light_faces(plan, scene);
    for (std::size_t setting = 0; setting < plan.spec.radiosity->reflectance.size(); ++setting) {
        const RadiositySystem system = lighting.system(setting, factors);
        place.put(
            fmt::format("system_{}", setting), coefficient_matrix(system),
            fmt::format("I - P F at reflectance {}", studies::in_words(plan.spec.radiosity->reflectance[setting])));
        if (setting == 0) place.put("emission", system.emission, "emitted exitance");
    }
}

Eigen::MatrixXd put_patch_factors(const MatrixPlace& place, const studies::StudyPlan& plan, std::size_t index,
                                  std::uint64_t trial) {
    Eigen::MatrixXd factors = studies::radiosity::trace_patch_factors(plan, index, trial);
    place.put("patch_form_factors", factors, "between patches, direct");
    return factors;
}

/// Factors between patches, and what turns them into a system. The matrix I - diag(reflectance) F itself is as large as
/// F.
void put_patches(const MatrixPlace& place, const studies::StudyPlan& plan, std::size_t index, std::uint64_t trial) {
    const studies::Cell& cell = plan.cells[index];
    put_patch_factors(place, plan, index, trial);
    place.put("patch_areas", patch_areas(plan.scenes[cell.scene], cell.subdivision), "areas of the patches");
    if (!plan.spec.radiosity) return;
    const studies::radiosity::PatchLight light = studies::radiosity::patch_light(plan, cell.scene, cell.subdivision);
    place.put("patch_emission", light.emission, "emitted exitance of the patches");
    for (std::size_t setting = 0; setting < light.reflectance.size(); ++setting)
        place.put(fmt::format("patch_reflectance_{}", setting), light.reflectance[setting],
                  "reflectance of the patches");
}

}  // namespace

void patch_systems(const studies::Store& store, const TakeMatrix& take) {
    const studies::StudyPlan& plan = store.plan();
    bool found = false;
    for (std::size_t index = 0; plan.spec.radiosity && index < plan.cells.size(); ++index) {
        if (!studies::tells_patches_apart(plan, index)) continue;
        const auto trials = store.saved_trial_numbers(index);
        if (trials.empty()) continue;
        studies::expect_few_patches(plan, index);
        found = true;
        const studies::Cell& cell = plan.cells[index];
        const MatrixPlace place = place_of_cell(take, plan, index, trials.front());
        const Eigen::MatrixXd factors = put_patch_factors(place, plan, index, trials.front());
        const studies::radiosity::PatchLight light =
            studies::radiosity::patch_light(plan, cell.scene, cell.subdivision);
        for (std::size_t setting = 0; setting < light.reflectance.size(); ++setting) {
            const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(factors.rows(), factors.cols()) -
                                           light.reflectance[setting].asDiagonal() * factors;
            place.put(fmt::format("patch_system_{}", setting), system,
                      fmt::format("I - P F between patches at reflectance {}",
                                  studies::in_words(plan.spec.radiosity->reflectance[setting])));
        }
    }
    if (!found) {
        throw UserError(
            "--format patch_systems: no system between patches (it takes [radiosity], and ray_shooting or area_kernel "
            "with several patches per face). Take --format matrices for those between faces.");
    }
}

std::map<std::string, std::string> matrix_files(const studies::Store& store) {
    const studies::StudyPlan& plan = store.plan();
    std::map<std::string, std::string> files;
    const TakeMatrix add = [&](const std::string& path, const Eigen::MatrixXd& matrix, const std::string& comment) {
        files[path + ".mtx"] = matrix_market(matrix, comment);
        files[path + ".npy"] = npy(matrix);
    };
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const auto exact = exact_room_factors(plan.scenes[scene]);
        if (exact) put_system({add, fmt::format("exact_{}/", scene), plan.scenes.name(scene)}, plan, scene, *exact);
    }
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const studies::Cell& cell = plan.cells[index];
        const auto trials = studies::radiosity::load_matrices(store, index);
        if (trials.direct.empty()) continue;
        const auto treatment = studies::radiosity::treatment_of(plan.spec.methods[cell.method].completion);
        const MatrixPlace place = place_of_cell(add, plan, index, trials.numbers.front());
        studies::radiosity::Elements faces;
        faces.areas = face_areas(plan.scenes[cell.scene]);
        faces.sight = studies::radiosity::face_sight(plan.scenes[cell.scene]);
        place.put("areas", faces.areas, "areas of the faces");
        put_system(place, plan, cell.scene,
                   studies::radiosity::treat(faces, trials.rays, trials.direct.front(), treatment));
        if (radiating_patches(plan.scenes[cell.scene], cell.subdivision) <= most_patches &&
            studies::tells_patches_apart(plan, index))
            put_patches(place, plan, index, trials.numbers.front());
    }
    return files;
}

}  // namespace ff::reports
