#pragma once

#include <Eigen/Core>

#include <optional>

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

/// A value known to lie in [low, high].
struct RadiusBounds {
    double low = 0;
    double high = 0;

    [[nodiscard]] double middle() const { return (low + high) / 2; }
};

/// Spectral radius of a matrix without negative entries, by power iteration. For every positive x it lies between the
/// least and the largest (A x)_i / x_i (Collatz, Wielandt): the bounds hold up to rounding, about n * 1e-16 of the
/// result, and iteration stops when their relative distance is within `tolerance`. They stay apart where the matrix is
/// reducible. @pre square, finite, no negative entry @see [varga1962] section 2.1
RadiusBounds spectral_radius(const Eigen::MatrixXd& matrix, double tolerance = 1e-12);

/// The defects of a matrix of form factors that errors cause.
struct FactorProperties {
    Eigen::VectorXd row_sums;
    double closure_defect = 0;      ///< largest |row sum - 1|; 0 in a closed scene without errors
    double reciprocity_defect = 0;  ///< largest |F_ij - F_ji A_j / A_i|; 0 without errors
    RadiusBounds spectral_radius;   ///< radius of F; 1 in a closed scene without errors

    /// The reflectance of all patches below which, but not from which on, G is strictly diagonally dominant: 1 / the
    /// largest row sum.
    [[nodiscard]] double dominant_below() const { return 1 / row_sums.maxCoeff(); }
};

/// @pre as for `spectral_radius`; areas > 0, one for each row
FactorProperties factor_properties(const Eigen::MatrixXd& factors, const Eigen::VectorXd& areas);

/// The properties that decide whether a system can be solved, and how fast.
struct SystemProperties {
    double dominance = 0;  ///< least |G_ii| - sum of |G_ij|, j != i: G is strictly diagonally dominant where it is > 0
    RadiusBounds spectral_radius;  ///< radius of P F: the series I + P F + (P F)^2 + ... converges where it is < 1
    double condition = 0;  ///< condition number of G in the 1-norm, estimated by LU factors; infinity: G is singular
};

struct SolvedSystem {
    SystemProperties properties;
    std::optional<Eigen::VectorXd> exitance;  ///< the result of `solve_exactly`
};

/// Both from one elimination, which dominates the cost of either for many patches. Holds two n x n matrices at a time.
SolvedSystem solve_with_properties(const RadiositySystem& system);

}  // namespace ff
