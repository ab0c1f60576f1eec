#include "core/visibility/contact.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/rounding_room.hpp"
#include "core/visibility/touching.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

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
