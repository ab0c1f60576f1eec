#pragma once

#include <Eigen/Core>

namespace ff {

/// The radiosity system G m = e with G = I - P F over n patches or faces: e is the emitted and m the total exitance
/// (power per area, any unit), P the diagonal matrix of reflectances. @see [baranoski1999] equations 10 to 12
struct RadiositySystem {
    Eigen::MatrixXd factors;      ///< F, n x n, from row to column, >= 0; F_ii > 0 where a patch sees itself
    Eigen::VectorXd areas;        ///< > 0, in any unit
    Eigen::VectorXd reflectance;  ///< in [0, 1)
    Eigen::VectorXd emission;     ///< e, >= 0

    [[nodiscard]] Eigen::Index size() const { return areas.size(); }
};

/// P F: the part of the exitance of others that is reflected.
Eigen::MatrixXd reflection_matrix(const RadiositySystem& system);

/// G = I - P F.
Eigen::MatrixXd coefficient_matrix(const RadiositySystem& system);

/// e - G m, without forming G.
Eigen::VectorXd residual(const RadiositySystem& system, const Eigen::VectorXd& exitance);

/// Emitted and absorbed power. They agree for the exact factors of a closed scene.
struct EnergyBalance {
    double emitted = 0;
    double absorbed = 0;

    /// (emitted - absorbed) / emitted: the share that errors of the factors lose, or create (negative).
    [[nodiscard]] double defect() const { return (emitted - absorbed) / emitted; }
};

/// @pre some patch emits
EnergyBalance energy_balance(const RadiositySystem& system, const Eigen::VectorXd& exitance);

}  // namespace ff
