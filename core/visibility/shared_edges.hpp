#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ff {

/// Which polygons of a scene meet along a whole edge of both. Normals agree across it.
class SharedEdges {
  public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    explicit SharedEdges(const std::vector<Surface>& surfaces);

    /// The outline of a surface; empty for round ones. Its k-th edge begins in the k-th corner.
    [[nodiscard]] const ConvexPolygon& outline(std::size_t surface) const { return outlines_[surface]; }
    [[nodiscard]] std::size_t size() const { return outlines_.size(); }
    /// Possible error of corners.
    [[nodiscard]] double corner_room() const { return corner_room_; }
    /// The surface beyond an edge; `none` where there is none or more than one.
    [[nodiscard]] std::uint32_t beyond(std::size_t surface, std::size_t edge) const {
        return beyond_[first_[surface] + edge];
    }

    /// Surfaces in groups that are connected by edges.
    /// @param joins  (surface, the one beyond an edge) -> whether they belong together
    template <class Joins>
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups(const Joins& joins) const {
        std::vector<std::uint32_t> group(size(), none);
        std::vector<std::vector<std::uint32_t>> groups;
        for (std::uint32_t first = 0; first < size(); ++first) {
            if (group[first] != none) continue;
            std::vector<std::uint32_t>& members = groups.emplace_back(1, first);
            group[first] = first;
            for (std::size_t k = 0; k < members.size(); ++k) {
                for (std::size_t edge = 0; edge < outlines_[members[k]].size(); ++edge) {
                    const std::uint32_t next = beyond(members[k], edge);
                    if (next == none || group[next] != none || !joins(members[k], next)) continue;
                    group[next] = first;
                    members.push_back(next);
                }
            }
        }
        return groups;
    }

  private:
    std::vector<ConvexPolygon> outlines_;
    std::vector<std::size_t> first_;  ///< place of each surface's edges
    std::vector<std::uint32_t> beyond_;
    double corner_room_ = 0;
};

}  // namespace ff
