#include "core/radiosity/system.hpp"

#include "core/support/contract.hpp"

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

}  // namespace ff
