#pragma once

#include "core/geometry/line_meets.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ff {

/// Boxes in a binary tree, in double precision: finds those that a line or another box may meet.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes);

    /// Calls visit(index of a box, latest) -> latest for boxes that the line may meet from time 0 to `latest`, nearer
    /// parts of the tree first. The returned value replaces `latest`.
    template <class Visit>
    void along(const Line& line, Visit visit) const {
        if (nodes_.empty()) return;
        const Eigen::Vector3d speed = line.direction.cwiseInverse();
        double latest = std::numeric_limits<double>::infinity();
        std::array<std::uint32_t, most_depth> waiting;
        std::size_t count = 0;
        std::uint32_t at = 0;
        while (true) {
            const Node& node = nodes_[at];
            if (entry(node.box, line.origin, speed) <= latest) {
                if (node.count == 0) {
                    const std::uint32_t left = at + 1;
                    const std::uint32_t right = node.first;
                    const bool left_first =
                        entry(nodes_[left].box, line.origin, speed) <= entry(nodes_[right].box, line.origin, speed);
                    waiting[count++] = left_first ? right : left;
                    at = left_first ? left : right;
                    continue;
                }
                for (std::uint32_t i = 0; i < node.count; ++i) latest = visit(order_[node.first + i], latest);
            }
            if (count == 0) return;
            at = waiting[--count];
        }
    }

    /// Calls visit(index) for every box that has a point in common with this one, larger by `room` on each side.
    template <class Visit>
    void within(const Eigen::AlignedBox3d& without_room, double room, Visit visit) const {
        if (nodes_.empty()) return;
        const Eigen::AlignedBox3d box(without_room.min().array() - room, without_room.max().array() + room);
        std::array<std::uint32_t, most_depth> waiting;
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = waiting[--count];
            const Node& node = nodes_[at];
            if (!node.box.intersects(box)) continue;
            if (node.count == 0) {
                waiting[count++] = at + 1;
                waiting[count++] = node.first;
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i) {
                if (boxes_[order_[node.first + i]].intersects(box)) visit(order_[node.first + i]);
            }
        }
    }

  private:
    /// Halved at the median, a tree of 2^32 boxes is no deeper.
    static constexpr std::size_t most_depth = 64;

    /// Its left half follows it.
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first = 0;  ///< first place in `order_` for a leaf, otherwise the index of the right half
        std::uint32_t count = 0;  ///< number of boxes in a leaf; 0 for other nodes
    };

    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;

    void build(std::uint32_t first, std::uint32_t end);

    /// When a line enters a box, 0 from inside; `infinity` where it misses the box. Allows for rounding.
    static double entry(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& speed) {
        constexpr double room = 1 + 8 * std::numeric_limits<double>::epsilon();
        double in = 0;
        double out = std::numeric_limits<double>::infinity();
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const double a = (box.min()[axis] - origin[axis]) * speed[axis];
            const double b = (box.max()[axis] - origin[axis]) * speed[axis];
            // Along a face of the box 0 * infinity is NaN, and both comparisons keep the other bound.
            const double low = a < b ? a : b;
            const double high = a < b ? b : a;
            if (low > in) in = low;
            if (high < out) out = high;
        }
        return in <= out * room ? in : std::numeric_limits<double>::infinity();
    }
};

}  // namespace ff
