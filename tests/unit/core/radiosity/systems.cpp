#include "tests/unit/core/radiosity/systems.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"

#include <random>

namespace ff::test {
namespace {

RadiositySystem system_of(const Scene& scene) {
    RadiositySystem system;
    system.factors = exact_form_factors(scene).value();
    const auto n = static_cast<int>(scene.faces.size());
    system.areas.resize(n);
    for (int i = 0; i < n; ++i) system.areas[i] = face_area(scene, i);
    return system;
}

}  // namespace

RadiositySystem lit_cube(double reflectance) {
    RadiositySystem system = system_of(built_in_scene("cube"));
    system.reflectance = Eigen::VectorXd::Constant(6, reflectance);
    system.emission = Eigen::VectorXd::Unit(6, 5);
    return system;
}

RadiositySystem lit_box() {
    RadiositySystem system = system_of(built_in_scene("box:2x1x0.5"));
    system.reflectance = (Eigen::VectorXd(6) << 0.2, 0.5, 0.5, 0, 0.9, 0.7).finished();
    system.emission = (Eigen::VectorXd(6) << 0, 0, 0.3, 0, 0, 1).finished();
    return system;
}

Eigen::MatrixXd shot_factors(std::uint64_t rays, std::uint64_t seed) {
    const Eigen::MatrixXd exact = lit_cube(0).factors;
    std::mt19937_64 engine(seed);
    Eigen::MatrixXd hits = Eigen::MatrixXd::Zero(6, 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Eigen::VectorXd row = exact.row(i);
        std::discrete_distribution<Eigen::Index> target(row.begin(), row.end());
        for (std::uint64_t ray = 0; ray < rays; ++ray) hits(i, target(engine)) += 1;
    }
    return hits / static_cast<double>(rays);
}

Eigen::MatrixXd mirrored(const Eigen::MatrixXd& factors) {
    Eigen::MatrixXd result = factors.triangularView<Eigen::StrictlyUpper>();
    return result + result.transpose();
}

}  // namespace ff::test
