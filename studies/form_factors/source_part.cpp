#include "studies/form_factors/source_part.hpp"

#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff::studies {

using Eigen::Vector3d;
using std::numbers::pi;

PartExtent extent_of(const Surface& source, const Vector3d& origin, const SourceCell& cell) {
    const SurfaceMap map(source);
    const auto at = [&](double s, double t) { return Vector3d(map.at(s, t).position - origin); };
    PartExtent part;
    const double s = (cell.s0 + cell.s1) / 2;
    const double t = (cell.t0 + cell.t1) / 2;
    part.centre = at(s, t);
    double along_s = (at(cell.s1, t) - at(cell.s0, t)).norm();
    double along_t = (at(s, cell.t1) - at(s, cell.t0)).norm();
    if (!corners(source.shape).empty()) {
        part.hull = {at(cell.s0, cell.t0), at(cell.s1, cell.t0), at(cell.s1, cell.t1), at(cell.s0, cell.t1)};
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
        along_t = 2 * pi * widest * (cell.t1 - cell.t0);
        part.size = along_s + along_t;
        part.radius = along_s + along_t / 2;
        if (zone != nullptr) part.turn = part.size / zone->radius;
        if (std::holds_alternative<Frustum>(shape)) part.turn = 2 * pi * (cell.t1 - cell.t0);
        part.turn = std::min(2.0, part.turn);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d sides((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
            part.hull.emplace_back(part.centre + part.radius * sides);
        }
    }
    part.s_longer = along_s >= along_t;
    return part;
}

double slope_of(const Surface& source, const PartExtent& part, const Edge& edge) {
    const double nearest = distance(part.centre, {edge.a, edge.b});
    const double away = nearest - part.radius;
    if (!(away > 0)) return HUGE_VAL;
    const Vector3d a = edge.a - part.centre;
    const Vector3d b = edge.b - part.centre;
    const double length = (b - a).norm();
    const double across = a.cross(b).norm();
    double sum = length / (nearest * nearest);  // the integral of 1 / r^2 along the edge
    if (across > 0) sum = std::min(sum, std::atan2(across, a.dot(b)) * length / across);
    double cosine = 1;
    if (is_flat(source.shape)) {
        const double height = std::max(source.normal.dot(a), source.normal.dot(b));
        cosine = std::clamp(height / away, 0.0, 1.0);
    }
    return sum * (nearest / away) * (nearest / away) * cosine / pi;
}

double ball_factor(double area, double distance, double height) {
    if (!(distance > 0)) return 1;
    return std::min(1.0, area / (pi * distance * distance) * std::min(1.0, height / distance));
}

}  // namespace ff::studies
