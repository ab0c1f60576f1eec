#include "core/exact/exact_rooms.hpp"

#include "core/exact/exact.hpp"
#include "core/exact/round_room.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numbers>
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
        if (corners(surface.shape).empty()) return std::nullopt;
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

}  // namespace ff
