#include "core/geometry/outlines.hpp"

#include "core/geometry/place_numbers.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ff {

using Eigen::Vector3d;

Outlines::Outlines(const Scene& scene, double gap) : scene_(scene) {
    PlaceNumbers number(gap);
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        polygons_.push_back(corners(scene.surfaces[i].shape));
        std::vector<std::uint32_t>& ring = rings_.emplace_back();
        for (const Vector3d& corner : polygons_[i]) {
            ring.push_back(number(corner));
            if (ring.back() == places_.size()) places_.push_back(corner);
        }
        // Corners of a parallelogram need not be in the order that the normal asks for.
        if (!ring.empty() && twice_area(polygons_[i]).dot(scene.surfaces[i].normal) < 0) {
            std::reverse(ring.begin(), ring.end());
            std::reverse(polygons_[i].begin(), polygons_[i].end());
        }
        for (std::size_t k = 0; k < ring.size(); ++k)
            at_edge_[edge_between(ring[k], next_corner(ring, k))].push_back(i);
    }
}

bool Outlines::runs(std::uint32_t surface, std::uint32_t from, std::uint32_t to) const {
    const auto& ring = rings_[surface];
    for (std::size_t k = 0; k < ring.size(); ++k) {
        if (ring[k] == from && next_corner(ring, k) == to) return true;
    }
    return false;
}

std::optional<std::uint32_t> Outlines::partner_at(std::uint32_t a, std::uint32_t b, std::uint32_t surface) const {
    const Edge edge = edge_between(a, b);
    constexpr double whole_turn = 2 * std::numbers::pi;
    constexpr double rounding = 1e-6;
    const Vector3d along = (places_[edge.second] - places_[edge.first]).normalized();
    const Vector3d x = along.unitOrthogonal();
    const Vector3d y = along.cross(x);
    const auto is_forward = [&](std::uint32_t of) { return runs(of, edge.first, edge.second); };
    // The direction from the edge into a surface, whose back is towards smaller angles if it runs forward.
    const auto angle_of = [&](std::uint32_t of) {
        const Vector3d inwards = scene_.surfaces[of].normal.cross(along) * (is_forward(of) ? 1 : -1);
        return std::atan2(y.dot(inwards), x.dot(inwards));
    };
    const double direction = is_forward(surface) ? -1 : 1;
    double nearest = 2 * whole_turn;
    std::optional<std::uint32_t> partner;
    for (const std::uint32_t other : at_edge_.at(edge)) {
        if (other == surface) continue;
        double angle = std::fmod(direction * (angle_of(other) - angle_of(surface)) + 2 * whole_turn, whole_turn);
        if (angle < rounding || angle > whole_turn - rounding) angle = whole_turn;
        const bool is_back = is_forward(other) != is_forward(surface);
        if (angle > nearest + rounding || (angle > nearest - rounding && !is_back)) continue;
        nearest = angle;
        partner = is_back ? std::optional(other) : std::nullopt;
    }
    // Another one in the same place faces it, or is its back in a plate: neither bounds a body with it here.
    return nearest < whole_turn ? partner : std::nullopt;
}

std::vector<std::uint32_t> Outlines::bodies() const {
    std::vector<std::uint32_t> body(polygons_.size());
    std::iota(body.begin(), body.end(), std::uint32_t{0});
    const auto root = [&](std::uint32_t at) {
        while (body[at] != at) at = body[at] = body[body[at]];
        return at;
    };
    for (const auto& [edge, surfaces] : at_edge_) {
        for (const std::uint32_t side : surfaces) {
            if (const auto partner = partner_at(edge.first, edge.second, side)) body[root(side)] = root(*partner);
        }
    }
    for (std::uint32_t i = 0; i < body.size(); ++i) body[i] = root(i);
    return body;
}

}  // namespace ff
