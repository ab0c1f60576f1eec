#include "core/exact/known_factors.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/coaxial_exchange.hpp"
#include "core/exact/exact.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/support/contract.hpp"
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

constexpr std::size_t most_rings = 64;

/// Exchange areas A_i F_ij between the surfaces of a closed convex room of revolution: discs and annuli, walls of
/// cylinders and cones, zones of spheres, all facing inward.
/// @return empty where the surfaces do not make such a room
std::optional<Eigen::MatrixXd> round_room_exchange(const Scene& scene) {
    if (scene.surfaces.empty() || scene.surfaces.size() > most_rings) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(scene.surfaces.size());
    Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Surface& from = scene.surfaces[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < n; ++j) {
            if (i == j && is_flat(from.shape)) continue;
            const auto exchange = coaxial_exchange_area(from, scene.surfaces[static_cast<std::size_t>(j)], {});
            if (!exchange) return std::nullopt;
            areas(i, j) = exchange->value;
        }
        // Where something is missing, not all that leaves a surface arrives.
        constexpr double rounding = 1e-12;
        const double whole = area(from.shape);
        if (std::abs(areas.row(i).sum() - whole) > rounding * whole) return std::nullopt;
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
    if (may_be_occluded(scene)) return "its faces may be occluded from each other";
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
