#pragma once

#include "core/radiosity/solver.hpp"
#include "studies/plan/plan.hpp"
#include "studies/radiosity/treatment.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff::studies::radiosity {

/// The systems of a scene, between its faces or its patches, without the factors of a trial.
struct Lighting {
    Elements elements;
    Eigen::MatrixXd exact;                     ///< form factors
    std::vector<Eigen::VectorXd> reflectance;  ///< for each setting, the reflectance of each element
    Eigen::VectorXd emission;

    /// The system with these factors instead of the exact ones.
    [[nodiscard]] RadiositySystem system(std::size_t setting, Eigen::MatrixXd factors) const;
};

/// Reflectance and emission of every patch.
struct PatchLight {
    std::vector<Eigen::VectorXd> reflectance;  ///< by setting
    Eigen::VectorXd emission;
};

/// All pairs of faces; a face with itself only where it sees itself.
Sight face_sight(const Scene& scene);

/// @pre the plan has a request
PatchLight patch_light(const StudyPlan& plan, std::size_t scene, Subdivision subdivision);
Lighting light_faces(const StudyPlan& plan, std::size_t scene);
/// @pre `light_faces`; more than one patch per face makes a difference
Lighting light_patches(const StudyPlan& plan, std::size_t scene, Subdivision subdivision);

SolverOptions solver_options(const StudyPlan& plan);

}  // namespace ff::studies::radiosity
