#include "core/radiosity/system.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff {

void expect_physical(const RadiositySystem& system) {
    const Eigen::Index n = system.size();
    if (n == 0 || system.factors.rows() != n || system.factors.cols() != n || system.reflectance.size() != n ||
        system.emission.size() != n) {
        throw UserError(fmt::format(
            "radiosity: {} areas, {} x {} form factors, {} reflectances, {} emissions (one of each for each "
            "patch is needed). Give all.",
            n, system.factors.rows(), system.factors.cols(), system.reflectance.size(), system.emission.size()));
    }
    const auto nonnegative = [](double value) { return std::isfinite(value) && value >= 0; };
    for (Eigen::Index i = 0; i < n; ++i) {
        if (!(nonnegative(system.reflectance[i]) && system.reflectance[i] < 1)) {
            throw UserError(
                fmt::format("radiosity: reflectance {} of patch {} (at least 0, and below 1: a surface that "
                            "absorbs nothing lets light pile up). Try 0.99.",
                            system.reflectance[i], i + 1));
        }
        if (!nonnegative(system.emission[i])) {
            throw UserError(
                fmt::format("radiosity: emission {} of patch {} (a surface does not emit less than nothing). "
                            "Give 0 or more.",
                            system.emission[i], i + 1));
        }
        if (!(nonnegative(system.areas[i]) && system.areas[i] > 0)) {
            throw UserError(fmt::format("radiosity: area {} of patch {} (above 0 is wanted). Give its area.",
                                        system.areas[i], i + 1));
        }
    }
    if (!std::all_of(system.factors.data(), system.factors.data() + system.factors.size(), nonnegative)) {
        throw UserError("radiosity: a form factor is negative or no number (it is a share of light). Leave it out.");
    }
}

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

}  // namespace ff
