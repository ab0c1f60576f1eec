#include "studies/form_factors/division/source_part.hpp"

#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff::studies::form_factors {

using Eigen::Vector3d;
using std::numbers::pi;

PartExtent extent_of(const Surface& source, const SurfaceMap& map, const Vector3d& origin, const SourceRange& range) {
    const auto at = [&](double s, double t) { return Vector3d(map.at(s, t).position - origin); };
    PartExtent part;
    const auto [s0, s1, t0, t1] = range;
    const double s = range.middle(true);
    const double t = range.middle(false);
    part.centre = at(s, t);
    double along_s = (at(s1, t) - at(s0, t)).norm();
    double along_t = (at(s, t1) - at(s, t0)).norm();
    if (!corners(source.shape).empty()) {
        part.hull = {at(s0, t0), at(s1, t0), at(s1, t1), at(s0, t1)};
        if (part.hull[0] == part.hull[3]) part.hull.pop_back();
        part.centre = Vector3d::Zero();
        for (const Vector3d& corner : part.hull) part.centre += corner / static_cast<double>(part.hull.size());
        for (const Vector3d& a : part.hull) {
            part.radius = std::max(part.radius, (a - part.centre).norm());
            for (const Vector3d& b : part.hull) part.size = std::max(part.size, (a - b).norm());
        }
    } else {
        // Along arcs: at most pi / 2 times the chord of half a turn, and no longer than the widest circle.
        const auto& shape = source.shape;
        double widest = 0;
        if (const auto* disc = std::get_if<Disc>(&shape)) widest = disc->outer_radius;
        if (const auto* wall = std::get_if<Frustum>(&shape)) widest = std::max(wall->base_radius, wall->top_radius);
        const auto* zone = std::get_if<SphereZone>(&shape);
        if (zone != nullptr) {
            widest = zone->radius;
            along_s *= pi / 2;
        }
        along_t = 2 * pi * widest * (t1 - t0);
        part.size = along_s + along_t;
        part.radius = along_s + along_t / 2;
        if (zone != nullptr) part.turn = part.size / zone->radius;
        if (std::holds_alternative<Frustum>(shape)) part.turn = 2 * pi * (t1 - t0);
        part.turn = std::min(2.0, part.turn);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d sides((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
            part.hull.emplace_back(part.centre + part.radius * sides);
        }
    }
    part.s_longer = along_s >= along_t;
    return part;
}

double ball_factor(double area, double distance, double height) {
    if (!(distance > 0)) return 1;
    return std::min(1.0, area / (pi * distance * distance) * std::min(1.0, height / distance));
}

}  // namespace ff::studies::form_factors
