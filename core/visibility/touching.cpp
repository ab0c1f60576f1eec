#include "core/visibility/touching.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

struct StraightLine {
    Vector3d point;
    Vector3d direction;  ///< unit length
};

/// The part of a line between two positions along it; empty unless begin < end.
struct Stretch {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
};

constexpr Stretch nowhere{0, 0};

double size_of(const ConvexPolygon& polygon) {
    return (polygon[1] - polygon[0]).norm() + (polygon[2] - polygon[1]).norm();
}

Vector3d normal(const ConvexPolygon& polygon) {
    return (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]).normalized();
}

/// Calls visit(a corner, the unit vector from the edge that begins there to the inside) for each edge.
template <class Visit>
void for_each_edge(const ConvexPolygon& polygon, Visit visit) {
    const Vector3d upwards = normal(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        visit(polygon[i], upwards.cross(next_corner(polygon, i) - polygon[i]).normalized());
    }
}

/// Where the planes of two polygons meet. @pre they are not parallel
StraightLine common_line(const Surface& a, const ConvexPolygon& of_a, const Surface& b, const ConvexPolygon& of_b) {
    const Vector3d direction = a.normal.cross(b.normal).normalized();
    // Measured from a's corner, so that rounding is relative to the surfaces and not to the origin.
    Eigen::Matrix3d planes;
    planes << a.normal.transpose(), b.normal.transpose(), direction.transpose();
    const Vector3d offsets(0, b.normal.dot(of_b[0] - of_a[0]), 0);
    return {of_a[0] + planes.partialPivLu().solve(offsets), direction};
}

/// The part of a line of its plane that lies on a convex polygon, rim included.
Stretch inside(const StraightLine& line, const ConvexPolygon& polygon) {
    Stretch part;
    const double gap = rounding_room * size_of(polygon);
    for_each_edge(polygon, [&](const Vector3d& corner, const Vector3d& inwards) {
        const double start = (line.point - corner).dot(inwards);
        const double slope = line.direction.dot(inwards);
        if (std::abs(slope) <= rounding_room) {
            if (start < -gap) part = nowhere;
        } else if (slope > 0) {
            part.begin = std::max(part.begin, -start / slope);
        } else {
            part.end = std::min(part.end, -start / slope);
        }
    });
    return part;
}

bool polygons_meet(const Surface& a, const ConvexPolygon& of_a, const Surface& b, const ConvexPolygon& of_b) {
    const StraightLine line = common_line(a, of_a, b, of_b);
    const Stretch on_a = inside(line, of_a);
    const Stretch on_b = inside(line, of_b);
    const double length = std::min(on_a.end, on_b.end) - std::max(on_a.begin, on_b.begin);
    return length > rounding_room * std::min(size_of(of_a), size_of(of_b));
}

struct Ring {
    Vector3d centre;
    Vector3d axis;
    double radius = 0;
};

std::vector<Ring> rims(const Surface& surface) {
    std::vector<Ring> all;
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        all = {{disc->centre, surface.normal, disc->inner_radius}, {disc->centre, surface.normal, disc->outer_radius}};
    } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        all = {{wall->base, wall->axis, wall->base_radius}, {wall->base + wall->axis, wall->axis, wall->top_radius}};
    } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        for (const double height : {zone->low, zone->high}) {
            all.push_back({zone->centre + zone->radius * height * zone->axis, zone->axis,
                           zone->radius * std::sqrt(std::max(0.0, (1 - height) * (1 + height)))});
        }
    }
    all.erase(std::remove_if(all.begin(), all.end(), [](const Ring& ring) { return ring.radius == 0; }), all.end());
    return all;
}

/// Three places of a circle fix it; a fourth tells a circle from what only crosses the surface.
bool ring_lies_on(const Ring& ring, const Surface& surface) {
    const Vector3d x = perpendicular(ring.axis);
    const Vector3d y = ring.axis.normalized().cross(x);
    const std::array<Vector3d, 4> directions{x, Vector3d(0.6 * y - 0.8 * x), Vector3d(-y),
                                             Vector3d(0.28 * x + 0.96 * y)};
    return std::all_of(directions.begin(), directions.end(), [&](const Vector3d& direction) {
        return lies_on(ring.centre + ring.radius * direction, surface, rounding_room * ring.radius);
    });
}

bool has_rim_on(const Surface& a, const Surface& b) {
    const std::vector<Ring> all = rims(a);
    return std::any_of(all.begin(), all.end(), [&](const Ring& ring) { return ring_lies_on(ring, b); });
}

}  // namespace

bool lies_on(const Vector3d& place, const Surface& surface, double gap) {
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        const Vector3d offset = place - disc->centre;
        const double radius = offset.norm();
        return std::abs(offset.dot(surface.normal)) <= gap && radius >= disc->inner_radius - gap &&
               radius <= disc->outer_radius + gap;
    }
    if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        const double height = wall->axis.norm();
        const Vector3d offset = place - wall->base;
        const double along = offset.dot(wall->axis) / height;
        const double radius = (offset - along * wall->axis / height).norm();
        const double expected = wall->base_radius + along / height * (wall->top_radius - wall->base_radius);
        const double slant = std::hypot(height, wall->top_radius - wall->base_radius);
        return along >= -gap && along <= height + gap && std::abs(radius - expected) * height / slant <= gap;
    }
    if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        const Vector3d offset = place - zone->centre;
        const double height = offset.dot(zone->axis);
        return std::abs(offset.norm() - zone->radius) <= gap && height >= zone->low * zone->radius - gap &&
               height <= zone->high * zone->radius + gap;
    }
    const ConvexPolygon polygon = corners(surface.shape);
    bool inside = std::abs((place - polygon[0]).dot(surface.normal)) <= gap;
    for_each_edge(polygon, [&](const Vector3d& corner, const Vector3d& inwards) {
        inside = inside && (place - corner).dot(inwards) >= -gap;
    });
    return inside;
}

bool are_parallel(const Surface& a, const Surface& b) {
    return is_flat(a.shape) && is_flat(b.shape) && a.normal.cross(b.normal).norm() <= rounding_room;
}

bool meet_along_line(const Surface& a, const Surface& b) {
    if (are_parallel(a, b)) return false;
    const ConvexPolygon of_a = corners(a.shape);
    const ConvexPolygon of_b = corners(b.shape);
    if (!of_a.empty() && !of_b.empty()) return polygons_meet(a, of_a, b, of_b);
    return has_rim_on(a, b) || has_rim_on(b, a);
}

namespace {

/// Contacts are not looked for in scenes with more surfaces: no estimator that suffers from contacts can handle as many
/// pairs.
constexpr std::size_t most_surfaces_for_contacts = 4096;

/// The sides of one patch that an edge or a corner belongs to.
using Sides = std::array<Side, 2>;

struct PatchEdge {
    Vector3d begin;
    Vector3d along;
    Sides sides;
};

struct PatchCorner {
    Vector3d place;
    Sides sides;
};

std::array<PatchEdge, 4> edges_of(const Parallelogram& p) {
    return {PatchEdge{p.corner, p.edge_v, {Side::low, Side::neither}},
            PatchEdge{p.corner + p.edge_u, p.edge_v, {Side::high, Side::neither}},
            PatchEdge{p.corner, p.edge_u, {Side::neither, Side::low}},
            PatchEdge{p.corner + p.edge_v, p.edge_u, {Side::neither, Side::high}}};
}

std::array<PatchCorner, 4> corners_of(const Parallelogram& p) {
    return {PatchCorner{p.corner, {Side::low, Side::low}}, PatchCorner{p.corner + p.edge_u, {Side::high, Side::low}},
            PatchCorner{p.corner + p.edge_v, {Side::low, Side::high}},
            PatchCorner{p.corner + p.edge_u + p.edge_v, {Side::high, Side::high}}};
}

/// Half of the longer diagonal.
double radius(const Parallelogram& p) {
    return std::max((p.edge_u + p.edge_v).norm(), (p.edge_u - p.edge_v).norm()) / 2;
}

Vector3d centre(const Parallelogram& p) {
    return p.corner + (p.edge_u + p.edge_v) / 2;
}

bool overlap(const PatchEdge& a, const PatchEdge& b, double gap) {
    const double length = a.along.norm();
    const Vector3d direction = a.along / length;
    const Vector3d begin = b.begin - a.begin;
    const Vector3d end = begin + b.along;
    if (begin.cross(direction).norm() > gap || end.cross(direction).norm() > gap) return false;
    const auto [low, high] = std::minmax({begin.dot(direction), end.dot(direction)});
    return std::min(length, high) - std::max(0.0, low) > gap;
}

/// Whether a place lies on a patch, rim included.
bool lies_on_patch(const Vector3d& place, const Parallelogram& p, double gap) {
    const Vector3d normal = p.edge_u.cross(p.edge_v);
    const double squared = normal.squaredNorm();
    const Vector3d offset = place - p.corner;
    const double u = offset.dot(p.edge_v.cross(normal)) / squared;
    const double v = offset.dot(normal.cross(p.edge_u)) / squared;
    const Vector3d nearest = std::clamp(u, 0.0, 1.0) * p.edge_u + std::clamp(v, 0.0, 1.0) * p.edge_v;
    return (offset - nearest).norm() <= gap;
}

Touch touch(Contact contact, const Sides& from, const Sides& to) {
    return {contact, {from[0], from[1], to[0], to[1]}};
}

/// The contact of two surfaces at least one of which is not a parallelogram.
Contact contact_of_shapes(const Surface& from, const Surface& to) {
    if (meet_along_line(from, to)) return Contact::edge;
    Contact contact = Contact::none;
    const auto look_at = [&](const Surface& a, const Surface& b) {
        const std::vector<Vector3d> of_a = corners(a.shape);
        for (const Vector3d& corner : of_a) {
            const double gap = rounding_room * ((of_a[1] - of_a[0]).norm() + (of_a[2] - of_a[1]).norm());
            if (!lies_on(corner, b, gap)) continue;
            contact = std::max(contact, Contact::point);
            for (const Vector3d& other : corners(b.shape)) {
                if ((corner - other).norm() <= gap) contact = Contact::vertex;
            }
        }
    };
    look_at(from, to);
    look_at(to, from);
    return contact;
}

Contact contact_of(const Surface& from, const Surface& to) {
    const auto* a = std::get_if<Parallelogram>(&from.shape);
    const auto* b = std::get_if<Parallelogram>(&to.shape);
    return a != nullptr && b != nullptr ? find_touch(*a, *b).contact : contact_of_shapes(from, to);
}

}  // namespace

Touch find_touch(const Parallelogram& from, const Parallelogram& to) {
    const double reach = radius(from) + radius(to);
    const double gap = rounding_room * reach;
    if ((centre(from) - centre(to)).squaredNorm() > (reach + gap) * (reach + gap)) return {};
    for (const PatchEdge& a : edges_of(from)) {
        for (const PatchEdge& b : edges_of(to)) {
            if (overlap(a, b, gap)) return touch(Contact::edge, a.sides, b.sides);
        }
    }
    for (const PatchCorner& a : corners_of(from)) {
        for (const PatchCorner& b : corners_of(to)) {
            if ((a.place - b.place).norm() <= gap) return touch(Contact::vertex, a.sides, b.sides);
        }
    }
    for (const PatchCorner& a : corners_of(from)) {
        if (lies_on_patch(a.place, to, gap)) return {Contact::point, {}};
    }
    for (const PatchCorner& b : corners_of(to)) {
        if (lies_on_patch(b.place, from, gap)) return {Contact::point, {}};
    }
    return {};
}

Contact closest_contact(const Scene& scene, int from_face, int to_face) {
    FF_EXPECT(from_face >= 0 && static_cast<std::size_t>(from_face) < scene.faces.size());
    FF_EXPECT(to_face >= 0 && static_cast<std::size_t>(to_face) < scene.faces.size());
    Contact closest = Contact::none;
    if (scene.surfaces.size() > most_surfaces_for_contacts) return closest;
    for (const Surface& from : scene.surfaces) {
        if (from.face != from_face) continue;
        for (const Surface& to : scene.surfaces) {
            if (to.face != to_face || !face_each_other(from, to)) continue;
            closest = std::max(closest, contact_of(from, to));
        }
    }
    return closest;
}

}  // namespace ff
