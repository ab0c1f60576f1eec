#include "core/patches/face_averages.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <vector>

namespace ff {

bool has_one_surface_a_face(const Scene& scene) {
    std::vector<std::size_t> surfaces(scene.faces.size());
    for (const Surface& surface : scene.surfaces) {
        if (is_of_face(surface)) ++surfaces[static_cast<std::size_t>(surface.face)];
    }
    return std::all_of(surfaces.begin(), surfaces.end(), [](std::size_t count) { return count == 1; });
}

Eigen::VectorXd parts_a_surface(const Scene& scene) {
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::VectorXd surfaces = Eigen::VectorXd::Zero(faces);
    Eigen::VectorXd parts = Eigen::VectorXd::Zero(faces);
    for (const Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) continue;
        surfaces[surface.face] += 1;
        parts[surface.face] += surface.grid.parts();
    }
    return parts.cwiseQuotient(surfaces);
}

Eigen::MatrixXd face_averages(const Scene& scene, std::span<const double> weighted, std::uint64_t rays) {
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    FF_EXPECT(weighted.size() == scene.faces.size() * scene.faces.size());
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(faces);
    for (const Surface& surface : scene.surfaces) {
        if (is_of_face(surface)) areas[surface.face] += area(surface.shape);
    }
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> sums(weighted.data(),
                                                                                                        faces, faces);
    return (areas * static_cast<double>(rays)).cwiseInverse().asDiagonal() * sums;
}

}  // namespace ff
