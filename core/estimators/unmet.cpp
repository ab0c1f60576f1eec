#include "core/estimators/unmet.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// Number of evaluations in a peak, or hits, from which on their own skewness shows their effect on the mean.
constexpr double enough = 30;

struct PlacedSurface {
    const Surface* surface;
    Eigen::AlignedBox3d box;
    double area;
};

std::vector<PlacedSurface> placed_surfaces(const Scene& scene, int face) {
    std::vector<PlacedSurface> found;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == face) found.push_back({&surface, box_around(surface), area(surface.shape)});
    }
    return found;
}

/// The largest distance of a surface's points from a straight line, or from a place where the direction is 0.
double farthest(const Surface& surface, const Eigen::Vector3d& place, const Eigen::Vector3d& direction) {
    const auto away = [&](const Eigen::Vector3d& point) {
        const Eigen::Vector3d offset = point - place;
        return (offset - direction.dot(offset) * direction).norm();
    };
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) return away(disc->centre) + disc->outer_radius;
    if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) return away(zone->centre) + zone->radius;
    if (const auto* wall = std::get_if<Frustum>(&surface.shape))
        return std::max(away(wall->base) + wall->base_radius, away(wall->base + wall->axis) + wall->top_radius);
    double most = 0;
    for (const Eigen::Vector3d& corner : corners(surface.shape)) most = std::max(most, away(corner));
    return most;
}

/// How far a surface lies at least inside of a hollow one; 0 where that is not shown.
double gap_inside(const Surface& hollow, const Surface& other) {
    double gap = 0;
    if (const auto* zone = std::get_if<SphereZone>(&hollow.shape))
        gap = zone->radius - farthest(other, zone->centre, Eigen::Vector3d::Zero());
    else if (const auto* wall = std::get_if<Frustum>(&hollow.shape))
        gap = std::min(wall->base_radius, wall->top_radius) - farthest(other, wall->base, wall->axis.normalized());
    return std::max(0.0, gap);
}

/// A lower bound of the squared distance of two surfaces, by planes between them and, for round ones, one within the
/// other; 0 where neither is found.
double squared_gap(const PlacedSurface& a, const PlacedSurface& b) {
    const double of_boxes = a.box.squaredExteriorDistance(b.box);
    if (of_boxes > a.area + b.area) return of_boxes;  // no peak, so that more precision would change nothing
    double gap = std::max(gap_inside(*a.surface, *b.surface), gap_inside(*b.surface, *a.surface));
    const auto try_plane = [&](const Eigen::Vector3d& normal) {
        const Extent along_a = extent(*a.surface, normal);
        const Extent along_b = extent(*b.surface, normal);
        gap = std::max({gap, along_a.low - along_b.high, along_b.low - along_a.high});
    };
    for (const PlacedSurface* each : {&a, &b}) {
        if (is_flat(each->surface->shape)) try_plane(each->surface->normal);
    }
    const Eigen::Vector3d between = b.box.center() - a.box.center();
    if (between.squaredNorm() > 0) try_plane(between.normalized());
    return std::max(of_boxes, gap * gap);
}

/// Two surfaces as a cause of a peak. The kernel is largest where points are about as close as the surfaces are, and a
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
    const auto targets = placed_surfaces(scene, to);
    for (const PlacedSurface& source : placed_surfaces(scene, from)) {
        for (const PlacedSurface& target : targets) {
            if (source.surface == target.surface || !face_each_other(*source.surface, *target.surface)) continue;
            const double squared = squared_gap(source, target);
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
    const auto targets = placed_surfaces(scene, to);
    for (const PlacedSurface& source : placed_surfaces(scene, from)) {
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
    const auto sources = placed_surfaces(scene, from);
    const bool is_part_of_sphere =
        from == to && sources.size() == 1 && std::holds_alternative<SphereZone>(sources.front().surface->shape);
    if (is_part_of_sphere) return 1;
    double squared = std::numeric_limits<double>::infinity();
    for (const PlacedSurface& target : placed_surfaces(scene, to)) {
        for (const PlacedSurface& source : sources) {
            if (face_each_other(*source.surface, *target.surface))
                squared = std::min(squared, squared_gap(source, target));
        }
    }
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
