#include "core/visibility/occluders.hpp"

#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::uint32_t most_in_leaf = 2;

AlignedBox3d box_of(const Surface& surface) {
    AlignedBox3d box;
    for (const Vector3d& corner : corners(surface.shape)) box.extend(corner);
    if (!box.isEmpty()) return box;
    Vector3d low;
    Vector3d high;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(surface, Vector3d::Unit(axis));
        low[axis] = along.low;
        high[axis] = along.high;
    }
    return {low, high};
}

bool is_polygon(const Surface& surface) {
    return !std::holds_alternative<Disc>(surface.shape) && is_flat(surface.shape);
}

/// Whether nothing of a box lies in front of a plane.
bool is_behind(const AlignedBox3d& box, const Vector3d& normal, double plane) {
    return normal.dot(box.center()) + normal.cwiseAbs().dot(box.sizes()) / 2 < plane;
}

/// The lines between two polygons, from the part of each that lies in front of the other, with places relative to the
/// middle of the first.
class Lines {
  public:
    Lines(const Surface& from, const Surface& to)
        : origin_(middle(from)), from_normal_(from.normal), to_normal_(to.normal) {
        const ConvexPolygon whole_from = moved(from);
        const ConvexPolygon whole_to = moved(to);
        from_plane_ = from_normal_.dot(whole_from.front());
        to_plane_ = to_normal_.dot(whole_to.front());
        from_ = clipped(whole_from, to_normal_, to_plane_);
        to_ = clipped(whole_to, from_normal_, from_plane_);
        for (const ConvexPolygon* polygon : {&from_, &to_}) {
            for (const Vector3d& corner : *polygon) box_.extend(corner);
        }
    }

    [[nodiscard]] bool are_none() const { return from_.empty() || to_.empty(); }

    enum class Crossed { none, some, all };

    [[nodiscard]] Crossed crossed_by(const Surface& occluder) const {
        ConvexPolygon part = clipped(clipped(moved(occluder), from_normal_, from_plane_), to_normal_, to_plane_);
        for (Eigen::Index axis = 0; axis < 3 && !part.empty(); ++axis) {
            const Vector3d along = Vector3d::Unit(axis);
            part = clipped(clipped(part, along, box_.min()[axis]), -along, -box_.max()[axis]);
        }
        const Shaft shaft(from_, to_);
        if (part.empty() || shaft.keeps_clear_of(part)) return Crossed::none;
        return shaft.is_closed_by(part) ? Crossed::all : Crossed::some;
    }

  private:
    Vector3d origin_;
    Vector3d from_normal_;
    Vector3d to_normal_;
    double from_plane_ = 0;
    double to_plane_ = 0;
    ConvexPolygon from_;
    ConvexPolygon to_;
    AlignedBox3d box_;

    [[nodiscard]] ConvexPolygon moved(const Surface& surface) const {
        ConvexPolygon result = corners(surface.shape);
        for (Vector3d& corner : result) corner -= origin_;
        return result;
    }
};

/// All surfaces as of one face, so that level ones are joined.
Scene without_faces(const Scene& scene) {
    Scene result = scene;
    for (Surface& surface : result.surfaces) surface.face = 0;
    return result;
}

}  // namespace

Occluders::Occluders(const Scene& scene) : ends_(scene.surfaces) {
    JoinedSurfaces joined = join_level_surfaces(without_faces(scene));
    surfaces_ = std::move(joined.scene.surfaces);
    of_ = std::move(joined.of);
    std::vector<AlignedBox3d> boxes;
    for (const Surface& surface : surfaces_) boxes.push_back(box_of(surface));
    order_.resize(surfaces_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), boxes);
}

std::uint32_t Occluders::build(std::uint32_t first, std::uint32_t count, const std::vector<AlignedBox3d>& boxes) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, first, count, 0});
    AlignedBox3d middles;
    for (std::uint32_t k = first; k < first + count; ++k) {
        nodes_[node].box.extend(boxes[order_[k]]);
        middles.extend(boxes[order_[k]].center());
    }
    if (count <= most_in_leaf) return node;
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const auto begin = order_.begin() + first;
    std::sort(begin, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(boxes[a].center()[axis], a) < std::pair(boxes[b].center()[axis], b);
    });
    build(first, count / 2, boxes);
    const std::uint32_t upper = build(first + count / 2, count - count / 2, boxes);
    nodes_[node].upper = upper;
    return node;
}

Occluders::Between Occluders::between(std::size_t from, std::size_t to) const {
    const Surface& a = ends_[from];
    const Surface& b = ends_[to];
    Between result;
    // A hollow surface is not joined to any, and stands in its own way.
    const auto stands_in_its_own_way = [&](const Surface& end) { return from != to && face_each_other(end, end); };
    const bool between_polygons = is_polygon(a) && is_polygon(b);
    AlignedBox3d box = box_of(a);
    box.extend(box_of(b));
    std::optional<Lines> lines;
    const auto examine = [&](std::uint32_t k) {
        const Surface& occluder = surfaces_[k];
        if (k == of_[from] || k == of_[to]) {
            if (stands_in_its_own_way(k == of_[from] ? a : b)) result.occluders.push_back(&occluder);
            return;
        }
        if (keeps_clear(occluder, a, b)) return;
        if (between_polygons && is_polygon(occluder)) {
            if (!lines) lines.emplace(a, b);
            const Lines::Crossed crossed = lines->are_none() ? Lines::Crossed::none : lines->crossed_by(occluder);
            if (crossed == Lines::Crossed::none) return;
            if (crossed == Lines::Crossed::all) result.all_hidden = true;
        }
        result.occluders.push_back(&occluder);
    };
    const auto plane = [](const Surface& surface) {
        return is_flat(surface.shape) ? extent(surface, surface.normal).low : 0;
    };
    const double plane_a = plane(a);
    const double plane_b = plane(b);
    std::vector<std::uint32_t> stack;
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty() && !result.all_hidden) {
        const std::uint32_t at = stack.back();
        stack.pop_back();
        const Node& node = nodes_[at];
        if ((node.box.min().array() > box.max().array()).any() || (node.box.max().array() < box.min().array()).any() ||
            is_behind(node.box, a.normal, plane_a) || is_behind(node.box, b.normal, plane_b))
            continue;
        if (node.upper == 0) {
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) examine(order_[k]);
        } else {
            stack.push_back(node.upper);
            stack.push_back(at + 1);
        }
    }
    std::sort(result.occluders.begin(), result.occluders.end());
    return result;
}

}  // namespace ff
