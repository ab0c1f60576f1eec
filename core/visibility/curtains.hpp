#pragma once

#include "core/geometry/shaft.hpp"
#include "core/visibility/bodies.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ff {

/// Walls that meet along edges and together hide everything between two ends, as a body can although none of its sides
/// does so alone. Lines cross a curtain the same number of times, counted by direction, if none passes its rim: then
/// one line decides for all.
class Curtains {
  public:
    /// @param plates  of the walls whose edges are given; empty for round ones. Both must outlive this.
    Curtains(const SharedEdges& edges, const std::vector<std::optional<Plate>>& plates);

    /// A convex set that lines begin or end in, by its corners; its normal is 0 unless all lines leave or reach it on
    /// that side.
    struct End {
        std::span<const Eigen::Vector3d> hull;
        Eigen::Vector3d normal;
        Eigen::AlignedBox3d box;
    };

    /// @param walls     that may stand between
    /// @param is_clear  whether no line crosses a wall that is not among them
    [[nodiscard]] bool hide_all(std::span<const std::uint32_t> walls, const End& from, const End& to, double grain,
                                const std::function<bool(std::uint32_t wall)>& is_clear);

  private:
    struct Line {
        Eigen::Vector3d begin;
        Eigen::Vector3d end;
        double length = 0;
    };
    const SharedEdges& edges_;
    const std::vector<std::optional<Plate>>& plates_;
    std::uint32_t count_ = 0;             ///< number of questions and curtains so far
    std::vector<std::uint32_t> asked_;    ///< for each wall, the last question in which it might stand between
    std::vector<std::uint32_t> reached_;  ///< for each wall, the last curtain that it might belong to
    std::vector<std::uint32_t> members_;

    /// How often a line crosses a wall: 1 from its front, -1 from behind; empty where that is not clear.
    [[nodiscard]] std::optional<int> crossings(std::uint32_t wall, const Line& line) const;
    [[nodiscard]] bool is_apart(std::uint32_t wall, const End& end) const;
};

}  // namespace ff
