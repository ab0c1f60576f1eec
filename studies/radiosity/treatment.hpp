#pragma once

#include "core/radiosity/correlated_repair.hpp"
#include "core/radiosity/repair.hpp"
#include "studies/trials/estimates.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies {

/// What is done to the direct estimates of a trial before the system is solved.
enum class Treatment {
    direct,      ///< nothing: every row comes from its own samples
    reciprocal,  ///< the lower triangle from the upper one
    normalised,  ///< the reciprocal matrix, every row divided by its sum
    balanced,    ///< least squares on all direct estimates: closed, reciprocal, nonnegative
    weighted,    ///< the same with the covariance that the method's own trials show
};

inline constexpr std::array all_treatments{Treatment::direct, Treatment::reciprocal, Treatment::normalised,
                                           Treatment::balanced, Treatment::weighted};

std::string_view name(Treatment treatment);

/// The treatment that corresponds to a method's own completion.
Treatment treatment_of(Completion completion);

/// The faces or patches that a matrix is between.
struct Elements {
    Eigen::VectorXd areas;
    Sight sight;
};

/// Known error statistics of direct estimates.
struct Uncertainty {
    Eigen::VectorXd rays;                      ///< per element, where factors are shares of counted hits; else empty
    std::vector<Eigen::MatrixXd> covariances;  ///< of each row over trials; empty where unknown
};

/// Direct estimates of all trials of a cell, between faces.
struct TrialMatrices {
    std::vector<std::uint64_t> numbers;  ///< of the trials
    std::vector<Eigen::MatrixXd> direct;
    Uncertainty errors;                ///< from all trials
    std::vector<RowScatter> scatters;  ///< of each row; empty where there are no covariances
};

/// From all trials but the one it is used for: the error of a trial that enters its own weights seems too small.
Uncertainty errors_without(const TrialMatrices& trials, std::size_t trial, const Sight& sight);

/// Fewest trials from which covariances are estimated.
inline constexpr std::size_t least_trials_of_covariances = 30;

TrialMatrices load_matrices(const Store& store, std::size_t cell);

/// A treated matrix; empty (0 x 0) where balancing finds none. @pre covariances for Treatment::weighted
Eigen::MatrixXd treat(const Elements& elements, const Uncertainty& errors, const Eigen::MatrixXd& direct,
                      Treatment treatment);

}  // namespace ff::studies
