#include "core/visibility/occluders.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

namespace ff {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

using Cluster = ClusterTree::Cluster;

/// Whether nothing of a cluster lies in front of another, which is flat.
bool is_behind(const Cluster& cluster, const Cluster& other) {
    if (!other.is_flat()) return false;
    const std::span<const Vector3d> hull = cluster.hull();
    return std::all_of(hull.begin(), hull.end(),
                       [&](const Vector3d& corner) { return other.normal.dot(corner) <= other.plane; });
}

bool are_apart(const AlignedBox3d& a, const AlignedBox3d& b) {
    return (a.min().array() > b.max().array()).any() || (a.max().array() < b.min().array()).any();
}

/// All surfaces as parts of one face, so that level ones are joined.
Scene without_faces(const Scene& scene) {
    Scene result = scene;
    for (Surface& surface : result.surfaces) surface.face = 0;
    return result;
}

/// The part of a polygon in front of another surface, if that is flat.
ConvexPolygon in_front_of(const Surface& polygon, const Surface& other) {
    ConvexPolygon whole = corners(polygon.shape);
    const ConvexPolygon others = corners(other.shape);
    if (others.empty()) return whole;
    return part_above(whole, [&](const Vector3d& corner) { return other.normal.dot(corner - others.front()); });
}

}  // namespace

/// Walks through pairs of clusters, with a stack of clusters that may stand between them.
class Occluders::Walk {
  public:
    explicit Walk(const Occluders& all) : all_(all), tree_(all.tree_), curtains_(all.edges_, all.plates_) {}

    /// Collects the visits that a pair of clusters is made of.
    void divide(std::uint32_t from, std::uint32_t to, std::size_t first, double most_pairs,
                std::vector<Visit>& visits) {
        const double pairs = pairs_of(from, to);
        if (pairs <= most_pairs || (tree_[from].is_leaf() && tree_[to].is_leaf())) {
            visits.push_back({from, to, {at(first), stack_.cend()}, pairs});
            return;
        }
        for_parts(from, to, first, [&](std::uint32_t a, std::uint32_t b, std::size_t begin) {
            divide(a, b, begin, most_pairs, visits);
        });
    }

    void see(std::uint32_t from, std::uint32_t to, std::size_t first, const See& see) {
        if (tree_[from].is_leaf() && tree_[to].is_leaf()) {
            std::uint32_t a = tree_.surface(tree_[from].first);
            std::uint32_t b = tree_.surface(tree_[to].first);
            if (a > b) std::swap(a, b);
            const Surface& surface = all_.surfaces_[a];
            const Surface& other = all_.surfaces_[b];
            if (surface.face == no_face || other.face == no_face || !all_.face_each_other(a, b)) return;
            const Between found = between(a, b, first);
            if (!found.all_hidden) see(a, b, found);
            return;
        }
        for_parts(from, to, first,
                  [&](std::uint32_t a, std::uint32_t b, std::size_t begin) { this->see(a, b, begin, see); });
    }

    /// Puts candidates that may stand between two clusters on the stack. @return false if everything is hidden
    /// @param first, last  places of the candidates on the stack
    bool filter(const Cluster& from, const Cluster& to, std::size_t first, std::size_t last) {
        const bool are_leaves = from.is_leaf() && to.is_leaf();
        const double coarse = are_leaves || (from.is_flat() && to.is_flat()) ? 0 : std::max(from.size, to.size) / 2;
        const AlignedBox3d box = from.box.merged(to.box);
        std::optional<Shaft> shaft;  // made when it is first needed
        waiting_.assign(at(first), at(last));
        while (!waiting_.empty()) {
            const std::uint32_t candidate = waiting_.back();
            waiting_.pop_back();
            const Cluster& cluster = tree_[candidate];
            if (are_apart(cluster.box, box) || is_behind(cluster, from) || is_behind(cluster, to)) continue;
            if (cluster.wall == ClusterTree::no_wall) {
                if (cluster.size > coarse) {
                    waiting_.push_back(candidate + 1);
                    waiting_.push_back(cluster.upper);
                } else {
                    stack_.push_back(candidate);
                }
                continue;
            }
            const std::optional<Plate>& plate = all_.plates_[cluster.wall];
            if (plate && (cluster.wall == from.wall || cluster.wall == to.wall)) continue;
            if (all_.are_level(cluster.wall, from.wall) || all_.are_level(cluster.wall, to.wall)) continue;
            if (plate && !are_leaves && &from != &to) {
                if (!shaft) shaft.emplace(from.hull(), to.hull(), std::min(from.grain, to.grain));
                const Shaft::Crossing crossing = shaft->crossed_by(*plate);
                if (crossing == Shaft::Crossing::none) continue;
                if (crossing == Shaft::Crossing::all && !all_.is_level_with_any_[cluster.wall]) return false;
            }
            stack_.push_back(candidate);
        }
        return true;
    }

    /// Whether walls on the stack from a place on hide together what none of them hides alone.
    [[nodiscard]] bool is_hidden_by_a_curtain(std::size_t first, const Cluster& from, const Cluster& to) {
        walls_.clear();
        unopened_.clear();
        for (std::size_t k = first; k < stack_.size(); ++k) {
            const std::uint32_t wall = tree_[stack_[k]].wall;
            wall == ClusterTree::no_wall ? unopened_.push_back(stack_[k]) : walls_.push_back(wall);
        }
        if (walls_.size() < 2) return false;
        // Walls that are not on the stack have been shown to be clear, unless they are an end or count as level with
        // one.
        const std::array ends{from.wall, to.wall};
        const auto is_clear = [this, &ends](std::uint32_t wall) {
            if (wall == ends[0] || wall == ends[1] || all_.is_level_with_any_[wall]) return false;
            const std::uint32_t place = all_.place_of_wall_[wall];
            return std::none_of(unopened_.begin(), unopened_.end(), [&](std::uint32_t cluster) {
                return place - tree_[cluster].first < tree_[cluster].count;
            });
        };
        return curtains_.hide_all(walls_, {from.hull(), from.normal, from.box}, {to.hull(), to.normal, to.box},
                                  std::min(from.grain, to.grain), is_clear);
    }

    /// How the walls on the stack, from a place on, affect two surfaces.
    [[nodiscard]] Between between(std::uint32_t from_index, std::uint32_t to_index, std::size_t first) const {
        const Surface& from = all_.surfaces_[from_index];
        const Surface& to = all_.surfaces_[to_index];
        Between result;
        const bool are_polygons = is_polygon(from.shape) && is_polygon(to.shape);
        const std::uint32_t from_wall = all_.wall_of(from_index);
        const std::uint32_t to_wall = all_.wall_of(to_index);
        std::optional<LinesBetween> lines;
        std::optional<Shaft> shaft;
        ConvexPolygon begin;
        ConvexPolygon end;
        for (std::size_t k = first; k < stack_.size(); ++k) {
            const std::uint32_t index = tree_[stack_[k]].wall;
            const Surface& wall = all_.walls_[index];
            if (all_.are_level(index, from_wall) || all_.are_level(index, to_wall)) continue;
            if (index == from_wall || index == to_wall) {
                // A hollow surface is not joined to any, and stands in its own way.
                if (from_index != to_index && ff::face_each_other(wall, wall)) result.occluders.emplace_back(&wall);
                continue;
            }
            Shaft::Crossing crossing = Shaft::Crossing::some;
            if (are_polygons && all_.plates_[index]) {
                if (!shaft) {
                    begin = in_front_of(from, to);
                    end = in_front_of(to, from);
                    if (begin.empty() || end.empty()) return {};
                    shaft.emplace(begin, end);
                }
                crossing = shaft->crossed_by(*all_.plates_[index]);
            }
            // A wall in the plane of an end, up to rounding, hides nothing.
            if (crossing == Shaft::Crossing::none) continue;
            if (!lines) lines.emplace(from, to);
            if (lines->keep_clear_of(wall)) continue;
            if (crossing == Shaft::Crossing::all) return {.all_hidden = true, .occluders = {}};
            if (are_polygons && all_.plates_[index] && shaft->is_beside(*all_.plates_[index])) continue;
            result.occluders.emplace_back(&wall);
        }
        std::sort(result.occluders.begin(), result.occluders.end(),
                  [](const Blocker& a, const Blocker& b) { return a.surface < b.surface; });
        if (!result.occluders.empty()) all_.drop_far_sides(result, from_index, to_index);
        return result;
    }

    void start_with(const std::vector<std::uint32_t>& candidates) { stack_ = candidates; }

  private:
    const Occluders& all_;
    const ClusterTree& tree_;
    std::vector<std::uint32_t> stack_;
    std::vector<std::uint32_t> waiting_;
    Curtains curtains_;
    std::vector<std::uint32_t> walls_;
    std::vector<std::uint32_t> unopened_;

    [[nodiscard]] std::vector<std::uint32_t>::const_iterator at(std::size_t place) const {
        return stack_.begin() + static_cast<std::ptrdiff_t>(place);
    }

    [[nodiscard]] double pairs_of(std::uint32_t from, std::uint32_t to) const {
        const auto [a, b] = std::pair<double, double>(tree_[from].count, tree_[to].count);
        return from == to ? a * (a + 1) / 2 : a * b;
    }

    /// Calls `go_on` for the parts of a pair of clusters, unless no line between them is clear, with the place on the
    /// stack where their candidates begin.
    template <class GoOn>
    void for_parts(std::uint32_t from, std::uint32_t to, std::size_t first, const GoOn& go_on) {
        const std::size_t last = stack_.size();
        const auto visit = [&](std::uint32_t a, std::uint32_t b) {
            const Cluster& begin = tree_[a];
            const Cluster& end = tree_[b];
            if (is_behind(begin, end) || is_behind(end, begin) || (begin.is_flat() && begin.wall == end.wall)) return;
            if (filter(begin, end, first, last) && (a == b || !is_hidden_by_a_curtain(last, begin, end)))
                go_on(a, b, last);
            stack_.resize(last);
        };
        if (from == to) {
            const std::uint32_t upper = tree_[from].upper;
            visit(from + 1, from + 1);
            visit(from + 1, upper);
            visit(upper, upper);
            return;
        }
        const Cluster& a = tree_[from];
        const Cluster& b = tree_[to];
        const bool from_is_coarser = a.is_flat() == b.is_flat() ? a.size >= b.size : b.is_flat();
        const bool divides_from = b.is_leaf() || (!a.is_leaf() && from_is_coarser);
        const std::uint32_t divided = divides_from ? from : to;
        for (const std::uint32_t half : {divided + 1, tree_[divided].upper})
            divides_from ? visit(half, to) : visit(from, half);
    }
};

Occluders::Occluders(const Scene& scene) : Occluders(scene, join_level_surfaces(without_faces(scene))) {}

Occluders::Occluders(const Scene& scene, const JoinedSurfaces& joined)
    : surfaces_(scene.surfaces),
      walls_(joined.scene.surfaces),
      are_none_(scene.empty_box || is_convex(scene)),
      edges_(walls_),
      bodies_(walls_, edges_),
      meshes_(edges_),
      tree_(surfaces_, joined) {
    for (const Surface& wall : walls_)
        plates_.push_back(is_polygon(wall.shape) ? std::optional(Plate(outline(wall))) : std::nullopt);
    place_of_wall_.resize(walls_.size());
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
        const ClusterTree::Cluster& leaf = tree_[tree_.leaf_of(s)];
        place_of_wall_[leaf.wall] = leaf.first;
    }
    for (const LevelOverlap& overlap : level_overlaps(scene)) {
        if (!overlap.level) continue;
        const auto [low, high] = std::minmax({wall_of(overlap.first), wall_of(overlap.second)});
        if (low != high) level_.emplace_back(low, high);
    }
    std::sort(level_.begin(), level_.end());
    level_.erase(std::unique(level_.begin(), level_.end()), level_.end());
    is_level_with_any_.resize(walls_.size());
    for (const auto& [low, high] : level_) is_level_with_any_[low] = is_level_with_any_[high] = true;
}

bool Occluders::are_level(std::uint32_t a, std::uint32_t b) const {
    const auto [low, high] = std::minmax(a, b);
    return high != ClusterTree::no_wall && is_level_with_any_[low] && is_level_with_any_[high] &&
           std::binary_search(level_.begin(), level_.end(), std::pair(low, high));
}

bool Occluders::face_each_other(std::size_t from, std::size_t to) const {
    return ff::face_each_other(surfaces_[from], surfaces_[to]) && !are_level(wall_of(from), wall_of(to));
}

std::vector<Occluders::Visit> Occluders::visits(double most_pairs) const {
    std::vector<Visit> visits;
    if (tree_.empty()) return visits;
    Walk walk(*this);
    walk.start_with(candidates());
    walk.divide(0, 0, 0, most_pairs, visits);
    return visits;
}

void Occluders::see(const Visit& visit, const See& see) const {
    Walk walk(*this);
    walk.start_with(visit.between);
    walk.see(visit.from, visit.to, 0, see);
}

Occluders::Between Occluders::between(std::size_t from, std::size_t to) const {
    Walk walk(*this);
    const std::vector<std::uint32_t> all = candidates();
    walk.start_with(all);
    const ClusterTree::Cluster& a = tree_[tree_.leaf_of(static_cast<std::uint32_t>(from))];
    const ClusterTree::Cluster& b = tree_[tree_.leaf_of(static_cast<std::uint32_t>(to))];
    walk.filter(a, b, 0, all.size());
    if (walk.is_hidden_by_a_curtain(all.size(), a, b)) return {.all_hidden = true, .occluders = {}};
    return walk.between(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), all.size());
}

std::vector<std::uint32_t> Occluders::candidates() const {
    if (are_none_) return {};
    return {0};
}

std::uint32_t Occluders::body_or_mesh(std::size_t wall) const {
    // A convex body belongs to a mesh with all its sides, or with none.
    if (const auto mesh = meshes_.of(wall)) return *mesh;
    const auto body = bodies_.of(wall);
    return body ? static_cast<std::uint32_t>(meshes_.size()) + *body : SharedEdges::none;
}

FacedEnd Occluders::end_to_face(std::size_t wall, std::size_t from, std::size_t to) const {
    const auto mesh = meshes_.of(wall);
    const auto body = bodies_.of(wall);
    for (const FacedEnd end : {FacedEnd::from, FacedEnd::to}) {
        const std::size_t surface = end == FacedEnd::from ? from : to;
        const ConvexPolygon polygon = corners(surfaces_[surface].shape);
        if (polygon.empty()) continue;
        if ((mesh && meshes_.is_on_free_side(*mesh, wall_of(surface), polygon)) ||
            (body && (!mesh || bodies_.is_closed(*body)) && bodies_.is_outside(*body, polygon)))
            return end;
    }
    return FacedEnd::either;
}

void Occluders::drop_far_sides(Between& between, std::size_t from, std::size_t to) const {
    // All sides of a body are checked against the same end: there might be none that face both.
    std::map<std::uint32_t, FacedEnd> ends;
    std::erase_if(between.occluders, [&](Blocker& occluder) {
        const std::size_t wall = index_of(occluder.surface);
        const std::uint32_t body = body_or_mesh(wall);
        if (body == SharedEdges::none) return false;
        const auto [known, is_new] = ends.try_emplace(body, FacedEnd::either);
        if (is_new) known->second = end_to_face(wall, from, to);
        occluder.faces = known->second;
        if (occluder.faces == FacedEnd::either) return false;
        const Plate& plate = *plates_[wall];
        const ConvexPolygon places = corners(surfaces_[occluder.faces == FacedEnd::from ? from : to].shape);
        return std::all_of(places.begin(), places.end(), [&](const Vector3d& place) {
            return plate.normal.dot(place - plate.corners.front()) <= edges_.corner_room();
        });
    });
}

}  // namespace ff
