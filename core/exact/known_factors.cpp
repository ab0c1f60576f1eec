#include "core/exact/known_factors.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/closed_forms.hpp"
#include "core/exact/exact.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/support/contract.hpp"
#include "core/support/overloaded.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_polygons = 64;

std::optional<Eigen::MatrixXd> polygons_exchange(const Scene& scene) {
    const std::size_t n = scene.surfaces.size();
    if (n > most_polygons || !is_convex(scene)) return std::nullopt;
    std::vector<Corners<long double>> polygons;
    for (const Surface& surface : scene.surfaces) {
        if (!is_polygon(surface.shape)) return std::nullopt;
        polygons.push_back(corners_of<long double>(surface));
    }
    Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto exchange = polygon_exchange_area<long double>(polygons[i], polygons[j]).value;
            areas(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = static_cast<double>(exchange);
            areas(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = static_cast<double>(exchange);
        }
    }
    return areas;
}

/// Lengths count as 0 up to this share of the room's size, and angles up to this.
constexpr double tolerance = 1e-12;
constexpr std::size_t most_rings = 64;

/// A circle around the axis.
struct Rim {
    long double height = 0;
    long double radius = 0;
};

/// The section of a surface with a plane through the axis: a line that climbs the surface, with the room on its left.
/// Directions are angles, 0 away from the axis and pi towards it.
struct Profile {
    Rim from, to;
    double direction_from = 0, direction_to = 0;
    Eigen::Index surface = 0;
};

struct Axis {
    Vector3d origin, direction;
};

Axis axis_of(const Shape& shape) {
    return std::visit(Overloaded{[](const Disc& disc) {
                                     return Axis{disc.centre, Vector3d::Zero()};
                                 },
                                 [](const Frustum& wall) {
                                     return Axis{wall.base, wall.axis.normalized()};
                                 },
                                 [](const SphereZone& zone) {
                                     return Axis{zone.centre, zone.axis};
                                 },
                                 [](const auto&) {
                                     return Axis{Vector3d::Zero(), Vector3d::Zero()};
                                 }},
                      shape);
}

/// +1 or -1 where a direction lies along the axis or against it, 0 elsewhere.
int sense(const Axis& axis, const Vector3d& direction) {
    if (direction.cross(axis.direction).norm() > tolerance) return 0;
    return direction.dot(axis.direction) > 0 ? 1 : -1;
}

long double height_on(const Axis& axis, const Vector3d& place) {
    return (place - axis.origin).dot(axis.direction);
}

bool lies_on(const Axis& axis, const Vector3d& place, double size) {
    return (place - axis.origin).cross(axis.direction).norm() <= tolerance * size;
}

std::optional<Profile> profile(const Surface& surface, const Axis& axis, double size) {
    const Axis own = axis_of(surface.shape);
    const bool flat = is_flat(surface.shape);
    const int up = sense(axis, flat ? surface.normal : own.direction);
    if (up == 0 || !lies_on(axis, own.origin, size)) return std::nullopt;
    if (!flat && facing(surface.shape) != Facing::inward) return std::nullopt;
    Profile result;
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        const long double height = height_on(axis, disc->centre);
        result.from = {height, disc->inner_radius};
        result.to = {height, disc->outer_radius};
        if (up < 0) result.direction_from = result.direction_to = std::numbers::pi;
    } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        result.from = {height_on(axis, wall->base), wall->base_radius};
        result.to = {height_on(axis, wall->base + wall->axis), wall->top_radius};
        const double climb = std::atan2(wall->axis.norm(), up * (wall->top_radius - wall->base_radius));
        result.direction_from = result.direction_to = climb;
    } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        const auto rim = [&](long double share) {
            return Rim{height_on(axis, zone->centre) + up * share * zone->radius,
                       zone->radius * std::sqrt((1 - share) * (1 + share))};
        };
        result.from = rim(zone->low);
        result.to = rim(zone->high);
        result.direction_from = std::acos(-up * (up > 0 ? zone->low : zone->high));
        result.direction_to = std::acos(-up * (up > 0 ? zone->high : zone->low));
    } else {
        return std::nullopt;
    }
    if (up < 0) std::swap(result.from, result.to);
    return result;
}

/// Where the meridian continues from a rim. @return empty where nothing or more than one surface follows
std::optional<std::size_t> next_of(const std::vector<Profile>& profiles, const Rim& rim, double size) {
    std::optional<std::size_t> next;
    for (std::size_t k = 0; k < profiles.size(); ++k) {
        const auto off = std::hypot(profiles[k].from.height - rim.height, profiles[k].from.radius - rim.radius);
        if (off > tolerance * size) continue;
        if (next) return std::nullopt;
        next = k;
    }
    return next;
}

/// The surfaces in their order from the lower end of the axis to the upper. Empty where they do not close, or bend away
/// from the axis.
std::vector<Profile> meridian(const std::vector<Profile>& profiles, double size) {
    std::vector<Profile> ordered;
    const auto first = std::find_if(profiles.begin(), profiles.end(), [&](const Profile& p) {
        return p.from.radius <= tolerance * size && p.direction_from < std::numbers::pi / 2;
    });
    if (first == profiles.end()) return {};
    ordered.push_back(*first);
    while (ordered.size() < profiles.size()) {
        const auto next = next_of(profiles, ordered.back().to, size);
        if (!next || profiles[*next].direction_from < ordered.back().direction_to - tolerance) return {};
        ordered.push_back(profiles[*next]);
    }
    if (ordered.back().to.radius > tolerance * size) return {};
    return ordered;
}

/// Exchange area of the discs that two rims bound.
long double exchange(const Rim& a, const Rim& b, double size) {
    const long double smaller = std::min(a.radius, b.radius);
    if (smaller <= tolerance * size) return 0;
    const long double distance = std::abs(a.height - b.height);
    const long double disc = std::numbers::pi_v<long double> * a.radius * a.radius;
    if (distance <= tolerance * size) return std::numbers::pi_v<long double> * smaller * smaller;
    return disc * coaxial_discs_factor(a.radius, b.radius, distance);
}

/// Exchange areas A_i F_ij between the surfaces of a closed convex room of revolution: discs and annuli, walls of
/// cylinders and cones, zones of spheres, one after the other around one axis, all facing inward. A line that passes
/// two rims crosses the discs that these rims bound, so that differences of exchange areas of coaxial discs [howell]
/// C-41 give all pairs, and closure gives what a surface sees of itself. In extended precision where the machine has
/// it: within about 1e-18 of the squared extent.
/// @return empty where the surfaces do not make such a room
std::optional<Eigen::MatrixXd> round_room_exchange(const Scene& scene) {
    if (!scene.closed || scene.surfaces.empty() || scene.surfaces.size() > most_rings) return std::nullopt;
    Axis axis = axis_of(scene.surfaces.front().shape);
    if (is_flat(scene.surfaces.front().shape)) axis.direction = scene.surfaces.front().normal;
    const double size = std::sqrt(area(scene.surfaces.front().shape)) + axis.origin.norm();
    std::vector<Profile> profiles;
    for (const Surface& surface : scene.surfaces) {
        auto found = profile(surface, axis, size);
        if (!found || !is_of_face(surface)) return std::nullopt;
        found->surface = static_cast<Eigen::Index>(profiles.size());
        profiles.push_back(*found);
    }
    const std::vector<Profile> rings = meridian(profiles, size);
    if (rings.empty()) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(rings.size());
    Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(n, n);
    for (const Profile& a : rings) {
        long double left = area(scene.surfaces[static_cast<std::size_t>(a.surface)].shape);
        for (const Profile& b : rings) {
            if (a.surface == b.surface) continue;
            const bool below = &a < &b;
            const Profile& low = below ? a : b;
            const Profile& high = below ? b : a;
            const long double both = exchange(low.to, high.from, size) - exchange(low.from, high.from, size) -
                                     exchange(low.to, high.to, size) + exchange(low.from, high.to, size);
            areas(a.surface, b.surface) = static_cast<double>(std::max(0.0L, both));
            left -= both;
        }
        if (!is_flat(scene.surfaces[static_cast<std::size_t>(a.surface)].shape))
            areas(a.surface, a.surface) = static_cast<double>(std::max(0.0L, left));
    }
    return areas;
}

/// A whole sphere; null for other shapes.
const SphereZone* sphere(const Surface& surface) {
    const auto* zone = std::get_if<SphereZone>(&surface.shape);
    return zone != nullptr && zone->low == -1 && zone->high == 1 ? zone : nullptr;
}

std::optional<Eigen::MatrixXd> spheres_exchange(const Scene& scene) {
    if (scene.surfaces.size() != 2) return std::nullopt;
    const SphereZone* const a = sphere(scene.surfaces[0]);
    const SphereZone* const b = sphere(scene.surfaces[1]);
    if (a == nullptr || b == nullptr || a->facing == b->facing) return std::nullopt;
    const SphereZone& outer = a->facing == Facing::inward ? *a : *b;
    const SphereZone& inner = a->facing == Facing::inward ? *b : *a;
    if ((outer.centre - inner.centre).norm() + inner.radius > outer.radius) return std::nullopt;
    const double shared = area(inner);
    const double left = 4 * std::numbers::pi * (outer.radius - inner.radius) * (outer.radius + inner.radius);
    Eigen::MatrixXd areas(2, 2);
    areas << (&outer == a ? left : 0), shared, shared, (&outer == a ? 0 : left);
    return areas;
}

/// Between surfaces, of a closed room all of whose surfaces are of faces.
std::optional<Eigen::MatrixXd> room_exchange(const Scene& scene) {
    const bool all_of_faces = std::none_of(scene.surfaces.begin(), scene.surfaces.end(),
                                           [](const Surface& surface) { return !is_of_face(surface); });
    if (!scene.closed || !all_of_faces) return std::nullopt;
    if (auto areas = polygons_exchange(scene)) return areas;
    if (auto areas = round_room_exchange(scene)) return areas;
    return spheres_exchange(scene);
}

/// Pairs of faces are not examined one by one in scenes with more surfaces than this: that takes time proportional to
/// the cube of their number.
constexpr std::size_t most_surfaces_pair_by_pair = 128;

}  // namespace

std::optional<Eigen::MatrixXd> exact_room_factors(const Scene& scene) {
    if (auto factors = exact_form_factors(scene)) return factors;
    const auto areas = room_exchange(scene);
    if (!areas) return std::nullopt;
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(faces, faces);
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        for (std::size_t j = 0; j < scene.surfaces.size(); ++j) {
            factors(scene.surfaces[i].face, scene.surfaces[j].face) +=
                (*areas)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) /
                face_area(scene, scene.surfaces[i].face);
        }
    }
    return factors;
}

std::string why_no_exact_factors(const Scene& scene) {
    if (!mirrors(scene).empty())
        return scene.empty_box ? "images in opposite mirrors are without end"
                               : "images in mirrors are known of boxes only";
    if (may_be_occluded(scene)) return "something may stand between its faces";
    return "they are known of rectangles along the axes, and of closed convex rooms with flat walls or of revolution";
}

KnownFactors::KnownFactors(const Eigen::MatrixXd& factors) : KnownFactors(static_cast<std::size_t>(factors.rows())) {
    FF_EXPECT(factors.rows() == factors.cols());
    for (int from = 0; from < factors.rows(); ++from) {
        for (int to = 0; to < factors.cols(); ++to) set(from, to, factors(from, to));
    }
}

std::size_t KnownFactors::index(int from, int to) const {
    FF_EXPECT(from >= 0 && static_cast<std::size_t>(from) < faces_);
    FF_EXPECT(to >= 0 && static_cast<std::size_t>(to) < faces_);
    return static_cast<std::size_t>(from) * faces_ + static_cast<std::size_t>(to);
}

std::optional<double> KnownFactors::row_sum(int from) const {
    double sum = 0;
    for (std::size_t to = 0; to < faces_; ++to) {
        const auto factor = at(from, static_cast<int>(to));
        if (!factor) return std::nullopt;
        sum += *factor;
    }
    return sum;
}

KnownFactors known_factors(const Scene& scene) {
    KnownFactors known(scene.faces.size());
    const auto all = exact_room_factors(scene);
    if (all) known = KnownFactors(*all);
    const bool pair_by_pair = !all && mirrors(scene).empty() && scene.surfaces.size() <= most_surfaces_pair_by_pair;
    const auto faces = static_cast<int>(scene.faces.size());
    for (int from = 0; from < faces; ++from) {
        for (int to = 0; to < faces; ++to) {
            auto factor = known_form_factor(scene, from, to);
            if (!factor && pair_by_pair && !may_be_occluded(scene, from, to))
                factor = exact_form_factor(scene, from, to);
            if (factor) known.set(from, to, *factor);
        }
    }
    return known;
}

std::optional<double> hidden_share(const Scene& scene, const KnownFactors& known, int from, int to) {
    const auto factor = known.at(from, to);
    const auto open = exact_form_factor(scene, from, to);
    if (!factor || !open || *open == 0) return std::nullopt;
    return std::clamp(1 - *factor / *open, 0.0, 1.0);
}

}  // namespace ff
