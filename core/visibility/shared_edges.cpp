#include "core/visibility/shared_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ff {
namespace {

/// Joining surfaces rounds their corners (core/geometry/joined_surfaces.hpp), by this share of the largest coordinate.
constexpr double corner_rounding = 1e-11;

/// Edges meet where corners are in one cell of a grid of this width. What is missed stays apart.
constexpr double same_corner = 1e-9;

}  // namespace

SharedEdges::SharedEdges(const std::vector<Surface>& surfaces) {
    double farthest = 0;
    for (const Surface& surface : surfaces) {
        outlines_.push_back(ff::outline(surface));
        for (const Eigen::Vector3d& corner : outlines_.back())
            farthest = std::max(farthest, corner.lpNorm<Eigen::Infinity>());
    }
    corner_room_ = corner_rounding * farthest;
    const double step = same_corner * farthest;
    using Corner = std::array<std::int64_t, 3>;
    const auto name_of = [&](const Eigen::Vector3d& place) {
        // Coordinates are often multiples of something, which lie in the middle of a cell so.
        const Eigen::Vector3d steps = (place / step).array() + 0.5;
        return Corner{std::llround(std::floor(steps.x())), std::llround(std::floor(steps.y())),
                      std::llround(std::floor(steps.z()))};
    };
    struct Edge {
        std::uint32_t surface;
        std::size_t place;
        bool alone = true;  ///< no other surface has it in the same direction
    };
    std::map<std::pair<Corner, Corner>, Edge> edges;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const ConvexPolygon& outline = outlines_[s];
        first_.push_back(beyond_.size());
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const std::pair ends(name_of(outline[k]), name_of(next_corner(outline, k)));
            const auto [known, is_new] = edges.try_emplace(ends, Edge{s, beyond_.size()});
            if (!is_new) known->second.alone = false;
            beyond_.push_back(none);
        }
    }
    const auto are_same = [&](const Edge& edge, const Edge& turned) {
        const auto ends = [&](const Edge& of) {
            const ConvexPolygon& outline = outlines_[of.surface];
            const std::size_t k = of.place - first_[of.surface];
            return std::pair(outline[k], next_corner(outline, k));
        };
        const auto [from, to] = ends(edge);
        const auto [last, first] = ends(turned);
        return (from - first).norm() <= 4 * corner_room_ && (to - last).norm() <= 4 * corner_room_;
    };
    for (const auto& [ends, edge] : edges) {
        const auto found = edges.find({ends.second, ends.first});
        if (found != edges.end() && found->second.alone && edge.alone && are_same(edge, found->second))
            beyond_[edge.place] = found->second.surface;
    }
}

}  // namespace ff
