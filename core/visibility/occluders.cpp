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
bool box_is_behind(const AlignedBox3d& box, const Vector3d& normal, double plane) {
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

    [[nodiscard]] Shaft::Crossing crossed_by(const Surface& occluder) const {
        ConvexPolygon part = clipped(clipped(moved(occluder), from_normal_, from_plane_), to_normal_, to_plane_);
        for (Eigen::Index axis = 0; axis < 3 && !part.empty(); ++axis) {
            const Vector3d along = Vector3d::Unit(axis);
            part = clipped(clipped(part, along, box_.min()[axis]), -along, -box_.max()[axis]);
        }
        return part.empty() ? Shaft::Crossing::none : Shaft(from_, to_).crossed_by(part);
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

/// Collects what may stand between two surfaces.
struct Proof {
    const Surface& from;
    const Surface& to;
    double room;
    bool of_polygons = is_polygon(from) && is_polygon(to);
    std::optional<Lines> lines{};  ///< made when they are first needed
    Occluders::Between result{};

    Proof(const Surface& from_surface, const Surface& to_surface, double rounding)
        : from(from_surface), to(to_surface), room(rounding) {}

    void examine(const Surface& occluder) {
        if (keeps_clear(occluder, from, to, room)) return;
        if (of_polygons && is_polygon(occluder)) {
            if (!lines) lines.emplace(from, to);
            if (lines->are_none()) return;
            const Shaft::Crossing crossing = lines->crossed_by(occluder);
            if (crossing == Shaft::Crossing::none) return;
            if (crossing == Shaft::Crossing::all) result.all_hidden = true;
        }
        result.occluders.push_back(&occluder);
    }
};

/// All surfaces as of one face, so that level ones are joined.
Scene without_faces(const Scene& scene) {
    Scene result = scene;
    for (Surface& surface : result.surfaces) surface.face = 0;
    return result;
}

}  // namespace

Occluders::Occluders(const Scene& scene) : Occluders(scene, join_level_surfaces(without_faces(scene))) {}

Occluders::Occluders(const Scene& scene, JoinedSurfaces joined)
    : ends_(scene.surfaces),
      surfaces_(std::move(joined.scene.surfaces)),
      bodies_(surfaces_),
      of_(std::move(joined.of)) {
    grain_.assign(surfaces_.size(), 1);
    std::vector<std::size_t> parts(surfaces_.size());
    for (const std::size_t wall : of_) ++parts[wall];
    for (std::size_t k = 0; k < ends_.size(); ++k) {
        double& grain = grain_[of_[k]];
        if (parts[of_[k]] > 1) grain = std::min(grain, area(ends_[k].shape) / area(surfaces_[of_[k]].shape));
    }
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

Occluders::Between Occluders::between_walls(std::size_t from, std::size_t to) const {
    const Surface& a = surfaces_[from];
    const Surface& b = surfaces_[to];
    // What is nothing beside a wall may be much beside the smallest surface that it is made of.
    const double room = rounding_room * std::min(grain_[from], grain_[to]);
    AlignedBox3d box = box_of(a);
    box.extend(box_of(b));
    const auto plane = [](const Surface& surface) {
        return is_flat(surface.shape) ? extent(surface, surface.normal).low : 0;
    };
    const double plane_a = plane(a);
    const double plane_b = plane(b);
    Proof proof(a, b, room);
    std::vector<std::uint32_t> stack;
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty() && !proof.result.all_hidden) {
        const std::uint32_t at = stack.back();
        stack.pop_back();
        const Node& node = nodes_[at];
        if ((node.box.min().array() > box.max().array()).any() || (node.box.max().array() < box.min().array()).any() ||
            box_is_behind(node.box, a.normal, plane_a) || box_is_behind(node.box, b.normal, plane_b))
            continue;
        if (node.upper == 0) {
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
                const Surface& occluder = surfaces_[order_[k]];
                // A hollow surface is not joined to any, and stands in its own way.
                if (&occluder != &a && &occluder != &b)
                    proof.examine(occluder);
                else if (from != to && face_each_other(occluder, occluder))
                    proof.result.occluders.push_back(&occluder);
            }
        } else {
            stack.push_back(node.upper);
            stack.push_back(at + 1);
        }
    }
    std::sort(proof.result.occluders.begin(), proof.result.occluders.end());
    if (one_body_hides_all(proof.result, a, b)) proof.result.all_hidden = true;
    return std::move(proof.result);
}

bool Occluders::one_body_hides_all(const Between& between, const Surface& from, const Surface& to) const {
    std::vector<std::uint32_t> bodies;
    for (const Surface* occluder : between.occluders) {
        if (const auto body = bodies_.of(index_of(occluder))) bodies.push_back(*body);
    }
    std::sort(bodies.begin(), bodies.end());
    const std::vector<Vector3d> begins = corners(from.shape);
    const std::vector<Vector3d> ends = corners(to.shape);
    if (begins.empty() || ends.empty()) return false;
    for (auto body = bodies.begin(); body != bodies.end(); body = std::upper_bound(body, bodies.end(), *body)) {
        const bool has_several_sides = body + 1 != bodies.end() && *body == *(body + 1);
        if (has_several_sides && bodies_.hides_all(*body, begins, ends)) return true;
    }
    return false;
}

void Occluders::drop_far_sides(Between& between, const Surface& from, const Surface& to) const {
    // A body is looked at from one of the two: together they would drop all of its sides.
    std::vector<std::uint32_t> seen_from_begins;
    for (const Surface* surface : {&from, &to}) {
        const std::vector<Vector3d> places = corners(surface->shape);
        if (places.empty()) continue;
        std::vector<std::uint32_t> dropped;
        std::erase_if(between.occluders, [&](const Surface* occluder) {
            const auto body = bodies_.of(index_of(occluder));
            if (!body || std::find(seen_from_begins.begin(), seen_from_begins.end(), *body) != seen_from_begins.end() ||
                !bodies_.is_met_before(index_of(occluder), places))
                return false;
            dropped.push_back(*body);
            return true;
        });
        seen_from_begins = std::move(dropped);
    }
}

Occluders::Between Occluders::between(std::size_t from, std::size_t to, const Between& of_walls) const {
    const std::size_t a = of_[from];
    const std::size_t b = of_[to];
    if (of_walls.all_hidden) return of_walls;
    Between result = grain_[a] == 1 && grain_[b] == 1 ? of_walls : between_parts(from, to, of_walls);
    if (!result.all_hidden && one_body_hides_all(result, ends_[from], ends_[to])) result.all_hidden = true;
    drop_far_sides(result, ends_[from], ends_[to]);
    return result;
}

Occluders::Between Occluders::between_parts(std::size_t from, std::size_t to, const Between& of_walls) const {
    Proof proof(ends_[from], ends_[to], rounding_room);
    for (const Surface* occluder : of_walls.occluders) {
        if (occluder == &surfaces_[of_[from]] || occluder == &surfaces_[of_[to]])
            proof.result.occluders.push_back(occluder);
        else
            proof.examine(*occluder);
        if (proof.result.all_hidden) break;
    }
    return std::move(proof.result);
}

Occluders::Between WallViews::between(std::size_t from, std::size_t to) {
    const std::pair walls(occluders_.wall_of(from), occluders_.wall_of(to));
    auto known = of_walls_.find(walls);
    if (known == of_walls_.end())
        known = of_walls_.emplace(walls, occluders_.between_walls(walls.first, walls.second)).first;
    return occluders_.between(from, to, known->second);
}

}  // namespace ff
