#pragma once

#include "core/radiosity/repair.hpp"
#include "core/radiosity/solver.hpp"
#include "studies/plan/plan.hpp"
#include "studies/trials/estimates.hpp"

#include <Eigen/Core>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies::radiosity {

/// The treatment of the direct estimates of a trial before the system is solved.
enum class Treatment {
    direct,      ///< nothing: every row comes from its own samples
    reciprocal,  ///< the lower triangle from the upper one
    normalised,  ///< the reciprocal matrix, every row divided by its sum
    balanced,    ///< least squares on all direct estimates: closed, reciprocal, nonnegative
};

inline constexpr std::array all_treatments{Treatment::direct, Treatment::reciprocal, Treatment::normalised,
                                           Treatment::balanced};

std::string_view name(Treatment treatment);

/// The treatment that corresponds to a method's own completion.
Treatment treatment_of(Completion completion);

/// The faces or patches that a matrix is between.
struct Elements {
    Eigen::VectorXd areas;
    Sight sight;
};

/// Direct estimates of all trials of a cell, between faces.
struct TrialMatrices {
    std::vector<std::uint64_t> numbers;  ///< number of each trial, as `direct` has them
    std::vector<Eigen::MatrixXd> direct;
    Eigen::VectorXd rays;  ///< rays shot from each face, where factors are shares of counted hits; else empty
};

TrialMatrices load_matrices(const Store& store, std::size_t cell);

/// Direct factors between the patches of a trial. They are not stored; the trial is repeated, with identical results,
/// since points are addressed. @pre tells_patches_apart @throws Interrupted once `stop` is true
Eigen::MatrixXd trace_patch_factors(const StudyPlan& plan, std::size_t index, std::uint64_t trial,
                                    const std::atomic<bool>* stop = nullptr);

/// A treated matrix; empty (0 x 0) where balancing finds none.
/// @param rays  of each element, where factors are shares of counted hits; else empty
Eigen::MatrixXd treat(const Elements& elements, const Eigen::VectorXd& rays, const Eigen::MatrixXd& direct,
                      Treatment treatment);

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
    std::vector<Eigen::VectorXd> reflectance;  ///< of every patch, for each setting
    Eigen::VectorXd emission;
};

/// The reflectance or emission of each face from the numbers of a request: one for each, or one for all. Without
/// numbers it is 1 for the last face and 0 for the others.
Eigen::VectorXd for_faces(const std::vector<double>& numbers, Eigen::Index faces);

/// All pairs of faces; a face with itself only where it sees itself.
Sight face_sight(const Scene& scene);

/// @pre the plan has a request
PatchLight patch_light(const StudyPlan& plan, std::size_t scene, Subdivision subdivision);
Lighting light_faces(const StudyPlan& plan, std::size_t scene);
/// @pre `light_faces`; more than one patch per face makes a difference
Lighting light_patches(const StudyPlan& plan, std::size_t scene, Subdivision subdivision);

SolverOptions solver_options(const StudyPlan& plan);

}  // namespace ff::studies::radiosity
