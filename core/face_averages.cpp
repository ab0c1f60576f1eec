#include "core/face_averages.hpp"

#include "core/contract.hpp"
#include "core/mirrors.hpp"

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

Eigen::MatrixXd face_averages(const Scene& scene, Subdivision subdivision, std::span<const std::uint64_t> patch_hits,
                              std::uint64_t rays) {
    const std::size_t faces = scene.faces.size();
    const std::size_t per_surface = subdivision.per_surface();
    FF_EXPECT(patch_hits.size() == per_surface * scene.surfaces.size() * faces);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(faces), static_cast<Eigen::Index>(faces));
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(faces));
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        if (!is_of_face(scene.surfaces[s])) continue;
        const int from = scene.surfaces[s].face;
        const double own = area(scene.surfaces[s].shape);
        areas[from] += own;
        for (std::size_t to = 0; to < faces; ++to) {
            std::uint64_t hits = 0;
            for (std::size_t p = s * per_surface; p < (s + 1) * per_surface; ++p) hits += patch_hits[p * faces + to];
            sums(from, static_cast<Eigen::Index>(to)) += own * static_cast<double>(hits);
        }
    }
    const double rays_of_a_surface = static_cast<double>(per_surface) * static_cast<double>(rays);
    return (areas * rays_of_a_surface).cwiseInverse().asDiagonal() * sums;
}

}  // namespace ff
