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
    return partner_among(at_edge_.at(edge), edge, surface);
}

std::optional<std::uint32_t> Outlines::partner_among(const std::vector<std::uint32_t>& at_edge, const Edge& edge,
                                                     std::uint32_t surface) const {
    if (at_edge.size() < 2) return std::nullopt;
    constexpr double rounding = 1e-6;
    const Vector3d along = (places_[edge.second] - places_[edge.first]).normalized();
    // The back of a surface that runs forward is towards smaller angles around the edge.
    const auto is_forward = [&](std::uint32_t side) { return runs(side, edge.first, edge.second); };
    const auto inwards = [&](std::uint32_t side) -> Vector3d {
        return scene_.surfaces[side].normal.cross(along) * (is_forward(side) ? 1 : -1);
    };
    const bool goes_forward = is_forward(surface);
    const Vector3d x = inwards(surface);
    const Vector3d y = along.cross(x) * (goes_forward ? -1 : 1);
    constexpr double whole_turn = 2 * std::numbers::pi;
    double nearest = whole_turn;
    std::optional<std::uint32_t> partner;
    for (const std::uint32_t other : at_edge) {
        const Vector3d into = inwards(other);
        // One in the same place faces it, or is its back in a plate: neither bounds a body with it here.
        if (other == surface || (into - x).norm() < rounding) continue;
        const bool is_back = is_forward(other) != goes_forward;
        if (at_edge.size() == 2) return is_back ? std::optional(other) : std::nullopt;
        const double angle = std::atan2(into.dot(y), into.dot(x));
        const double turn = angle < 0 ? angle + whole_turn : angle;
        if (turn > nearest + rounding || (turn > nearest - rounding && !is_back)) continue;
        nearest = turn;
        partner = is_back ? std::optional(other) : std::nullopt;
    }
    return partner;
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
            if (const auto partner = partner_among(surfaces, edge, side)) body[root(side)] = root(*partner);
        }
    }
    for (std::uint32_t i = 0; i < body.size(); ++i) body[i] = root(i);
    return body;
}

}  // namespace ff
