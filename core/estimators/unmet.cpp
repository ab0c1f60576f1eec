#include "core/estimators/unmet.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// Evaluations in a peak, or hits, from which on their own skewness shows what they make of the mean.
constexpr double enough = 30;

struct PlacedSurface {
    const Surface* surface;
    Eigen::AlignedBox3d box;
    double area;
};

std::vector<PlacedSurface> surfaces_of(const Scene& scene, int face) {
    std::vector<PlacedSurface> found;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == face) found.push_back({&surface, box_around(surface), area(surface.shape)});
    }
    return found;
}

Eigen::AlignedBox3d box_of(const std::vector<PlacedSurface>& surfaces) {
    Eigen::AlignedBox3d box;
    for (const PlacedSurface& surface : surfaces) box.extend(surface.box);
    return box;
}

/// Two surfaces as a peak has them. The kernel is largest where points are about as close as the surfaces are, and a
/// factor where the point lies beneath the target or within that distance of it.
struct Peak {
    double squared_distance;
    double kernel;           ///< bound of the kernel, for points spread over the whole target face
    double share_of_points;  ///< share of the points of the source face
    double share_of_pairs;   ///< share of the pairs of points of both faces
};

/// Calls `use` with the peak of each two surfaces of the faces that face each other.
template <class Use>
void for_each_peak(const Scene& scene, int from, int to, Use use) {
    const double from_area = face_area(scene, from);
    const double to_area = face_area(scene, to);
    const auto targets = surfaces_of(scene, to);
    for (const PlacedSurface& source : surfaces_of(scene, from)) {
        for (const PlacedSurface& target : targets) {
            if (source.surface == target.surface || !face_each_other(*source.surface, *target.surface)) continue;
            const double squared = source.box.squaredExteriorDistance(target.box);
            const double near = std::min(source.area, target.area + squared) / from_area;
            use(Peak{.squared_distance = squared,
                     .kernel = to_area / (std::numbers::pi * squared),
                     .share_of_points = near,
                     .share_of_pairs = near * std::min(target.area, squared) / to_area});
        }
    }
}

/// A factor that the one between two faces hardly falls below where nothing stands in between: as if all points were as
/// far from each other as the farthest are. 0 where a surface is curved.
double least_factor(const Scene& scene, int from, int to) {
    double sum = 0;
    const auto targets = surfaces_of(scene, to);
    for (const PlacedSurface& source : surfaces_of(scene, from)) {
        for (const PlacedSurface& target : targets) {
            if (!is_flat(source.surface->shape) || !is_flat(target.surface->shape)) continue;
            const Eigen::Vector3d line = middle(*target.surface) - middle(*source.surface);
            const double cosines = source.surface->normal.dot(line) * -target.surface->normal.dot(line);
            Eigen::AlignedBox3d both = source.box;
            both.extend(target.box);
            if (cosines > 0 && target.surface->normal.dot(line) < 0)
                sum += source.area * target.area * cosines /
                       (std::numbers::pi * line.squaredNorm() * both.diagonal().squaredNorm());
        }
    }
    return sum / face_area(scene, from);
}

}  // namespace

double largest_kernel(const Scene& scene, int from, int to) {
    const auto sources = surfaces_of(scene, from);
    const bool is_part_of_sphere =
        from == to && sources.size() == 1 && std::holds_alternative<SphereZone>(sources.front().surface->shape);
    if (is_part_of_sphere) return 1;
    const double squared = box_of(sources).squaredExteriorDistance(box_of(surfaces_of(scene, to)));
    return face_area(scene, to) / (std::numbers::pi * squared);
}

double largest_unmet_kernel(const Scene& scene, int from, int to, double evaluations) {
    if (may_be_seen_in_part(scene, from, to)) return largest_kernel(scene, from, to);
    double largest = 0;
    for_each_peak(scene, from, to, [&](const Peak& peak) {
        if (peak.squared_distance > 0 && peak.share_of_pairs * evaluations < enough)
            largest = std::max(largest, peak.kernel);
    });
    return largest;
}

double largest_unmet_factor(const Scene& scene, int from, int to, double evaluations) {
    if (may_be_seen_in_part(scene, from, to)) return std::min(1.0, largest_kernel(scene, from, to));
    double sum = 0;
    for_each_peak(scene, from, to, [&](const Peak& peak) {
        if (peak.share_of_points * evaluations < enough) sum += std::min(1.0, peak.kernel);
    });
    return std::min(1.0, sum);
}

double largest_unmet_hit(const Scene& scene, int from, int to, double evaluations, double largest) {
    const bool is_met =
        !may_be_seen_in_part(scene, from, to) && least_factor(scene, from, to) / largest * evaluations >= enough;
    return is_met ? 0 : largest;
}

}  // namespace ff
