#include "core/radiosity/system.hpp"

#include "core/support/contract.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace ff {

Eigen::MatrixXd reflection_matrix(const RadiositySystem& system) {
    return system.reflectance.asDiagonal() * system.factors;
}

Eigen::MatrixXd coefficient_matrix(const RadiositySystem& system) {
    return Eigen::MatrixXd::Identity(system.size(), system.size()) - reflection_matrix(system);
}

Eigen::VectorXd residual(const RadiositySystem& system, const Eigen::VectorXd& exitance) {
    const Eigen::VectorXd irradiance = system.factors * exitance;
    return system.emission - exitance + system.reflectance.cwiseProduct(irradiance);
}

EnergyBalance energy_balance(const RadiositySystem& system, const Eigen::VectorXd& exitance) {
    FF_EXPECT(system.emission.maxCoeff() > 0);
    const Eigen::VectorXd irradiance = system.factors * exitance;
    const Eigen::VectorXd absorbed = (1 - system.reflectance.array()).matrix().cwiseProduct(irradiance);
    return {system.areas.dot(system.emission), system.areas.dot(absorbed)};
}

RadiusBounds spectral_radius(const Eigen::MatrixXd& matrix, double tolerance) {
    FF_EXPECT(matrix.rows() == matrix.cols() && matrix.size() > 0);
    FF_EXPECT(matrix.minCoeff() >= 0 && matrix.allFinite());
    constexpr int most_power_steps = 2000;
    constexpr double smallest_entry = 1e-280;  // least entry of x before quotients lose digits
    Eigen::VectorXd x = Eigen::VectorXd::Ones(matrix.rows());
    RadiusBounds bounds{0, std::numeric_limits<double>::infinity()};
    for (int step = 0; step < most_power_steps; ++step) {
        const Eigen::VectorXd image = matrix * x;
        const Eigen::VectorXd quotients = image.cwiseQuotient(x);
        bounds.low = std::max(bounds.low, quotients.minCoeff());
        bounds.high = std::min(bounds.high, quotients.maxCoeff());
        if (bounds.high - bounds.low <= tolerance * bounds.high) break;
        // A + shift has the same vector, and no second eigenvalue of the same modulus, as that of two patches has.
        x = image + bounds.high / 2 * x;
        x /= x.maxCoeff();
        if (x.minCoeff() < smallest_entry) break;
    }
    // Rounding may let ends that are equal cross.
    return {std::min(bounds.low, bounds.high), std::max(bounds.low, bounds.high)};
}

FactorProperties factor_properties(const Eigen::MatrixXd& factors, const Eigen::VectorXd& areas) {
    FF_EXPECT(factors.rows() == areas.size());
    FactorProperties properties;
    properties.row_sums = factors.rowwise().sum();
    properties.closure_defect = (properties.row_sums.array() - 1).abs().maxCoeff();
    const Eigen::MatrixXd exchange = areas.asDiagonal() * factors;
    const Eigen::MatrixXd difference = areas.cwiseInverse().asDiagonal() * (exchange - exchange.transpose());
    properties.reciprocity_defect = difference.cwiseAbs().maxCoeff();
    properties.spectral_radius = spectral_radius(factors);
    return properties;
}

SolvedSystem solve_with_properties(const RadiositySystem& system) {
    SolvedSystem solved;
    solved.properties.spectral_radius = spectral_radius(reflection_matrix(system));
    Eigen::MatrixXd coefficients = coefficient_matrix(system);
    const Eigen::VectorXd diagonal = coefficients.diagonal().cwiseAbs();
    solved.properties.dominance = (2 * diagonal - coefficients.cwiseAbs().rowwise().sum()).minCoeff();
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factorised(coefficients);  // overwrites them
    const double reciprocal = factorised.rcond();
    solved.properties.condition = reciprocal > 0 ? 1 / reciprocal : std::numeric_limits<double>::infinity();
    if (reciprocal > std::numeric_limits<double>::epsilon())
        solved.exitance = Eigen::VectorXd(factorised.solve(system.emission));
    return solved;
}

}  // namespace ff
