#include "core/geometry/joined_surfaces.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Directions are parallel if the sine of the angle between them is at most this. Differences between components of
/// unit vectors are likewise 0 up to this.
constexpr double straight = 1e-10;

/// An edge, whichever way it is walked.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct EdgeHash {
    std::size_t operator()(const Edge& edge) const {
        return std::hash<std::uint64_t>{}((std::uint64_t{edge.first} << 32) + edge.second);
    }
};

bool are_parallel(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() <= straight * a.norm() * b.norm();
}

/// Joins pieces two by two. A piece that has been joined to another is empty.
class Joiner {
  public:
    explicit Joiner(const Scene& scene);

    void join_triangles();
    /// Parallelograms in rows, then rows side by side, until nothing changes.
    void join_parallelograms();
    [[nodiscard]] JoinedSurfaces result(const Scene& scene) const;

  private:
    std::vector<std::optional<Surface>> pieces_;
    std::vector<std::size_t> joined_to_;  ///< the piece that holds another, or is on its way there; itself at the end
    PlaceNumbers number_;
    std::unordered_map<Edge, std::vector<std::size_t>, EdgeHash> at_edge_;  ///< pieces, also those swallowed since

    [[nodiscard]] Edge edge_between(const Vector3d& a, const Vector3d& b) {
        const std::uint32_t from = number_(a);
        const std::uint32_t to = number_(b);
        return {std::min(from, to), std::max(from, to)};
    }
    [[nodiscard]] bool are_level(const Surface& a, const Surface& b) const {
        return a.face == b.face && a.normal.dot(b.normal) > 0 && are_parallel(a.normal, b.normal);
    }
    void index_edges(std::size_t piece);
    /// The other piece at the edge that can be joined to this one: level with it and accepted.
    template <class Accept>
    [[nodiscard]] std::optional<std::size_t> neighbour(std::size_t piece, const Edge& edge, Accept accept) const;
    bool extend(std::size_t piece, bool first_direction);
    void swallow(std::size_t piece, std::size_t other) {
        pieces_[other].reset();
        joined_to_[other] = piece;
    }
};

double largest_coordinate_of(const Scene& scene) {
    double largest = 0;
    for (const Surface& surface : scene.surfaces) {
        for (const Vector3d& corner : corners(surface.shape)) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    }
    return largest;
}

Joiner::Joiner(const Scene& scene)
    : pieces_(scene.surfaces.begin(), scene.surfaces.end()),
      number_(std::max(resolution_of_places * largest_coordinate_of(scene), std::numeric_limits<double>::min())) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        joined_to_.push_back(i);
        index_edges(i);
    }
}

void Joiner::index_edges(std::size_t piece) {
    const std::vector<Vector3d> around = corners(pieces_[piece]->shape);
    for (std::size_t i = 0; i < around.size(); ++i) {
        at_edge_[edge_between(around[i], next_corner(around, i))].push_back(piece);
    }
}

template <class Accept>
std::optional<std::size_t> Joiner::neighbour(std::size_t piece, const Edge& edge, Accept accept) const {
    const auto found = at_edge_.find(edge);
    if (found == at_edge_.end()) return std::nullopt;
    for (const std::size_t other : found->second) {
        if (other != piece && pieces_[other] && are_level(*pieces_[piece], *pieces_[other]) && accept(*pieces_[other]))
            return other;
    }
    return std::nullopt;
}

/// Twice in one triangle: its corner across from the longest edge, then the ends of that in order around it.
std::array<Vector3d, 3> from_apex(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    const double ab = (b - a).squaredNorm();
    if (bc >= ca && bc >= ab) return {a, b, c};
    if (ca >= ab) return {b, c, a};
    return {c, a, b};
}

void Joiner::join_triangles() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (!pieces_[i] || !std::holds_alternative<Triangle>(pieces_[i]->shape)) continue;
        const auto [apex, b, c] = from_apex(std::get<Triangle>(pieces_[i]->shape));
        const Edge longest = edge_between(b, c);
        const std::uint32_t opposite = number_(b + c - apex);
        const auto other = neighbour(i, longest, [&](const Surface& surface) {
            const auto* triangle = std::get_if<Triangle>(&surface.shape);
            if (triangle == nullptr) return false;
            const auto around = {triangle->a, triangle->b, triangle->c};
            return std::any_of(around.begin(), around.end(),
                               [&](const Vector3d& corner) { return number_(corner) == opposite; });
        });
        if (!other) continue;
        pieces_[i]->shape = Parallelogram{apex, b - apex, c - apex};
        swallow(i, *other);
        index_edges(i);
    }
}

/// The unit vector along `v` or against it, whichever has a positive first component among those that are not 0.
Vector3d unsigned_direction(const Vector3d& v) {
    Vector3d unit = v.normalized();
    Eigen::Index axis = 0;
    while (axis < 2 && std::abs(unit[axis]) <= straight) ++axis;
    if (unit[axis] < 0) unit = -unit;
    return unit;
}

/// Whether `a` comes before `b` in an order that does not depend on the signs of directions, so that all tiles of a
/// wall agree on it, however they are wound.
bool comes_first(const Vector3d& a, const Vector3d& b) {
    const Vector3d difference = unsigned_direction(a) - unsigned_direction(b);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (std::abs(difference[axis]) > straight) return difference[axis] > 0;
    }
    return false;
}

/// Joins a piece to one that continues it at either end of its first (or second) direction.
bool Joiner::extend(std::size_t piece, bool first_direction) {
    const auto [corner, u, v] = std::get<Parallelogram>(pieces_[piece]->shape);
    const bool along_u = comes_first(u, v) == first_direction;
    const Vector3d along = along_u ? u : v;
    const Vector3d across = along_u ? v : u;
    for (const bool at_end : {true, false}) {
        const Vector3d end = at_end ? Vector3d(corner + along) : corner;
        const Vector3d outwards = at_end ? along : Vector3d(-along);
        const auto other = neighbour(piece, edge_between(end, end + across), [&](const Surface& surface) {
            const auto* next = std::get_if<Parallelogram>(&surface.shape);
            if (next == nullptr) return false;
            const Vector3d to_middle = next->corner + (next->edge_u + next->edge_v) / 2 - end - across / 2;
            return to_middle.dot(outwards) > 0 && are_parallel(to_middle, along);
        });
        if (!other) continue;
        // Twice the way from the common edge to the middle.
        const Parallelogram& next = std::get<Parallelogram>(pieces_[*other]->shape);
        const Vector3d more = 2 * (next.corner - end) + next.edge_u + next.edge_v - across;
        const Vector3d start = at_end ? corner : Vector3d(corner + more);
        const Vector3d longer = at_end ? Vector3d(along + more) : Vector3d(along - more);
        pieces_[piece]->shape = along_u ? Parallelogram{start, longer, across} : Parallelogram{start, across, longer};
        swallow(piece, *other);
        index_edges(piece);
        return true;
    }
    return false;
}

void Joiner::join_parallelograms() {
    for (bool changed = true; changed;) {
        changed = false;
        for (const bool first_direction : {true, false}) {
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                while (pieces_[i] && std::holds_alternative<Parallelogram>(pieces_[i]->shape) &&
                       extend(i, first_direction)) {
                    changed = true;
                }
            }
        }
    }
}

JoinedSurfaces Joiner::result(const Scene& scene) const {
    JoinedSurfaces result{scene, {}};
    result.scene.surfaces.clear();
    std::vector<std::size_t> index(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (!pieces_[i]) continue;
        index[i] = result.scene.surfaces.size();
        result.scene.surfaces.push_back(*pieces_[i]);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        std::size_t holder = i;
        while (joined_to_[holder] != holder) holder = joined_to_[holder];
        result.of.push_back(index[holder]);
    }
    return result;
}

}  // namespace

JoinedSurfaces join_level_surfaces(const Scene& scene) {
    Joiner joiner(scene);
    joiner.join_triangles();
    joiner.join_parallelograms();
    return joiner.result(scene);
}

}  // namespace ff
