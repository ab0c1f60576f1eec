#include "core/visibility/visible_polygon.hpp"

#include "core/formulas/polygon_factor.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;
/// Few corners, so that none of them is allocated.
using SmallPolygon = boost::container::small_vector<Vector3d, 12>;
using Heights = boost::container::small_vector<double, 12>;

/// Relative to `place`.
void see_from(const Vector3d& place, std::span<const Vector3d> polygon, SmallPolygon& result) {
    result.resize(polygon.size(), boost::container::default_init);
    for (std::size_t k = 0; k < polygon.size(); ++k) result[k] = polygon[k] - place;
}

/// Possible error of places, and of heights above planes, as a share of the largest coordinate.
constexpr double coordinate_rounding = 16 * std::numeric_limits<double>::epsilon();

/// The part of a convex polygon where sign * height >= 0; none of less than three corners.
SmallPolygon part_of(const SmallPolygon& polygon, const Heights& heights, double sign) {
    SmallPolygon part;
    // A convex polygon gains one corner at most; one that is not quite convex, by rounding, may cross more often.
    part.resize(2 * polygon.size(), boost::container::default_init);
    std::size_t size = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const double before = sign * heights[k];
        const double after = sign * next_corner(heights, k);
        if (before >= 0) part[size++] = polygon[k];
        if ((before > 0 && after < 0) || (before < 0 && after > 0))
            part[size++] = polygon[k] + (next_corner(polygon, k) - polygon[k]) * (before / (before - after));
    }
    part.resize(size < 3 ? 0 : size);
    return part;
}

/// Heights above a plane through the origin, those of corners in it but for rounding being 0: else what is cut off
/// there leaves edges so short that rounding decides which way they run. @return whether some are below
bool find_heights(const SmallPolygon& polygon, const Vector3d& normal, double rounding, Heights& heights) {
    heights.resize(polygon.size(), boost::container::default_init);
    bool some_below = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const double height = normal.dot(polygon[k]);
        heights[k] = std::abs(height) <= rounding ? 0 : height;
        some_below = some_below || heights[k] < 0;
    }
    return some_below;
}

/// Takes the part where normal * v < 0 off a convex polygon. @return whether there is one; what is left may be empty
/// @param off  where not null: gets that part
bool cut(SmallPolygon& polygon, const Vector3d& normal, double rounding, SmallPolygon* off = nullptr) {
    Heights heights;
    if (!find_heights(polygon, normal, rounding, heights)) return false;
    if (off != nullptr) *off = part_of(polygon, heights, -1);
    polygon = part_of(polygon, heights, 1);
    return true;
}

/// Blockers may be before each other by this share of the size of all.
constexpr double convex_room = 1e-14;

/// From this many blockers on, it pays to determine first which of them are beside the target.
constexpr std::size_t least_for_cone = 3;

/// An edge has to be this many times as long as the rounding of coordinates.
constexpr double roundings_of_edge = 256;

/// Room for the rounding of a triple product, relative to the lengths of its factors.
constexpr double product_rounding = 4e-15;

/// Planes through the origin and the edges of a polygon, normals of any length towards its inside; none where it is
/// seen edge-on, or so nearly that rounding decides where its inside is. Edges of a few roundings are left out: they
/// take nothing off.
void find_sides(const SmallPolygon& polygon, double rounding, SmallPolygon& sides) {
    sides.clear();
    Vector3d middle = Vector3d::Zero();
    Heights squares;
    for (const Vector3d& corner : polygon) {
        middle += corner;
        squares.push_back(product_rounding * corner.squaredNorm());
    }
    const double farthest = middle.squaredNorm();
    const double shortest = roundings_of_edge * rounding;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d side = polygon[k].cross(next_corner(polygon, k));
        const double room = squares[k] * next_corner(squares, k);
        const double length = (next_corner(polygon, k) - polygon[k]).squaredNorm();
        if (length <= shortest * shortest || side.squaredNorm() <= room) continue;  // two corners in one
        const double height = side.dot(middle);
        if (height * height <= room * farthest) return sides.clear();
        sides.push_back(height > 0 ? side : Vector3d(-side));
    }
    if (sides.size() < 3) sides.clear();
}

/// @param room  what reaches no further inside is outside
bool is_outside(const SmallPolygon& piece, const SmallPolygon& sides, double room = 0) {
    return std::any_of(sides.begin(), sides.end(), [&](const Vector3d& side) {
        return std::all_of(piece.begin(), piece.end(), [&](const Vector3d& v) { return side.dot(v) <= room; });
    });
}

/// Leaves out sides of a shadow that all of a piece is inside of, and gives the others unit length. @return whether
/// some of the piece may be in the shadow
bool keep_those_that_cut(SmallPolygon& sides, const SmallPolygon& piece) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        bool some_inside = false;
        bool some_outside = false;
        for (const Vector3d& v : piece) {
            const double height = sides[k].dot(v);
            some_inside = some_inside || height > 0;
            some_outside = some_outside || height < 0;
        }
        if (!some_inside) return false;
        if (some_outside) sides[kept++] = sides[k].normalized();
    }
    sides.resize(kept);
    return true;
}

/// The part of a convex piece that a shadow hides, given by the planes of its sides: the whole piece where nothing
/// differs.
bool hide(SmallPolygon& piece, const SmallPolygon& shadow, double rounding) {
    bool differs = false;
    for (const Vector3d& side : shadow) {
        differs = cut(piece, side, rounding) || differs;
        if (piece.empty()) break;
    }
    return differs;
}

// NOLINTNEXTLINE(bugprone-exception-escape): moving a small vector of vectors throws nothing.
struct Shadow {
    std::uint32_t blocker = 0;
    bool of_front = false;  ///< the blocker is seen from the front
    SmallPolygon sides;     ///< normals of the planes around it, towards its inside
};

/// Adds the part of a convex piece that no shadow hides. What a shadow hides is taken off the sum where no other one
/// hides any of that, as with neighbours in a mesh; else the piece is cut up along the shadow's sides.
class Adding {
  public:
    /// @param are_convex  for two blockers: no line meets the same side of both
    Adding(const std::vector<bool>& are_convex, std::size_t blockers, double rounding, ArcSums& sums, std::size_t place)
        : are_convex_(are_convex), blockers_(blockers), rounding_(rounding), sums_(sums), place_(place) {}

    // NOLINTNEXTLINE(misc-no-recursion): each level has fewer shadows.
    void add(SmallPolygon piece, std::span<const Shadow> shadows) {
        for (; !shadows.empty(); shadows = shadows.subspan(1)) {
            const Shadow& shadow = shadows.front();
            const std::span<const Shadow> others = shadows.subspan(1);
            if (is_outside(piece, shadow.sides, rounding_)) continue;
            SmallPolygon hidden = piece;
            if (!hide(hidden, shadow.sides, rounding_)) return;
            if (hidden.empty()) continue;
            const auto overlaps = [&](const Shadow& other) {
                return !are_apart(shadow, other) && !is_outside(hidden, other.sides, rounding_);
            };
            if (std::any_of(others.begin(), others.end(), overlaps)) {
                for (const Vector3d& side : shadow.sides) {
                    SmallPolygon outside;
                    cut(piece, side, rounding_, &outside);
                    if (!outside.empty()) add(std::move(outside), others);
                    if (piece.empty()) break;
                }
                return;
            }
            sums_.add(place_, hidden, 1);
        }
        sums_.add(place_, piece, -1);
    }

  private:
    const std::vector<bool>& are_convex_;
    std::size_t blockers_;
    double rounding_;
    ArcSums& sums_;
    std::size_t place_;

    [[nodiscard]] bool are_apart(const Shadow& a, const Shadow& b) const {
        return a.of_front == b.of_front && are_convex_[a.blocker * blockers_ + b.blocker];
    }
};

}  // namespace

VisiblePolygon::VisiblePolygon(const Surface& target, const std::vector<Blocker>& blockers, FacedEnd place_at)
    : target_(outline(target)), target_normal_(target.normal) {
    FF_EXPECT(!target_.empty());
    // Parts of blockers that lie behind the target's plane hide nothing.
    const Vector3d origin = target_.front();
    const auto allow_for = [&](const ConvexPolygon& polygon) {
        for (const Vector3d& corner : polygon)
            rounding_ = std::max(rounding_, coordinate_rounding * corner.lpNorm<Eigen::Infinity>());
    };
    allow_for(target_);
    for (const Blocker& blocker : blockers) allow_for(corners(blocker.surface->shape));
    for (const Blocker& blocker : blockers) {
        FF_EXPECT(is_polygon(blocker.surface->shape));
        hides_.push_back(blocker.faces == FacedEnd::either ? Hides::always
                         : blocker.faces == place_at       ? Hides::from_before
                                                           : Hides::from_behind);
        SmallPolygon part;
        see_from(origin, outline(*blocker.surface), part);
        cut(part, target_normal_, rounding_);
        std::vector<Vector3d>& kept = blockers_.emplace_back();
        for (const Vector3d& corner : part) kept.emplace_back(origin + corner);
    }
    find_convex_pairs();
    all_.resize(blockers_.size());
    std::iota(all_.begin(), all_.end(), 0U);
}

void VisiblePolygon::find_convex_pairs() {
    const std::size_t count = blockers_.size();
    are_convex_.resize(count * count);
    double size = 0;
    const auto reach = [&](const ConvexPolygon& polygon) {
        for (const Vector3d& corner : polygon) size = std::max(size, (corner - target_.front()).norm());
    };
    reach(target_);
    for (const ConvexPolygon& blocker : blockers_) {
        reach(blocker);
        Plane& plane = planes_.emplace_back();
        if (blocker.empty()) continue;
        plane.normal = twice_area(blocker).normalized();
        plane.offset = plane.normal.dot(blocker.front());
    }
    const double room = convex_room * size;
    const auto is_behind = [&](std::size_t blocker, const Plane& plane) {
        return std::all_of(blockers_[blocker].begin(), blockers_[blocker].end(),
                           [&](const Vector3d& corner) { return plane.normal.dot(corner) <= plane.offset + room; });
    };
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < a; ++b)
            are_convex_[a * count + b] = are_convex_[b * count + a] =
                is_behind(a, planes_[b]) && is_behind(b, planes_[a]);
    }
}

VisiblePolygon::Factors VisiblePolygon::from(const Vector3d& place, const Vector3d& normal,
                                             std::span<const std::uint32_t> blockers) const {
    Factors result;
    find({&place, 1}, normal, blockers, {&result, 1});
    return result;
}

void VisiblePolygon::find(std::span<const Vector3d> places, const Vector3d& normal,
                          std::span<const std::uint32_t> blockers, std::span<Factors> result) const {
    FF_EXPECT(result.size() == places.size());
    // Two sums for each place: of the whole, and of what differs from it.
    ArcSums sums(normal, 2 * places.size());
    enum class Seen : std::uint8_t { nothing, all, all_but, part };
    boost::container::small_vector<Seen, 32> sights(places.size(), Seen::nothing);
    SmallPolygon whole;
    SmallPolygon cone;
    SmallPolygon blocker;
    SmallPolygon sides;
    boost::container::small_vector<Shadow, 4> shadows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Vector3d& place = places[k];
        if (target_normal_.dot(target_.front() - place) >= 0) continue;
        const double rounding = std::max(rounding_, coordinate_rounding * place.lpNorm<Eigen::Infinity>());
        see_from(place, target_, whole);
        cut(whole, normal, rounding);
        if (whole.empty()) continue;
        // Corners run clockwise as seen from the place that the polygon's normal points to.
        sums.add(2 * k, whole, -1);
        if (blockers.size() >= least_for_cone) find_sides(whole, rounding, cone);
        shadows.clear();
        for (const std::uint32_t index : blockers) {
            const bool is_before = planes_[index].is_before(place);
            if (hides_[index] == (is_before ? Hides::from_behind : Hides::from_before)) continue;
            see_from(place, blockers_[index], blocker);
            if (is_outside(blocker, cone)) continue;
            cut(blocker, normal, rounding);
            if (blocker.empty()) continue;
            find_sides(blocker, rounding, sides);
            if (!sides.empty() && keep_those_that_cut(sides, whole)) shadows.push_back({index, is_before, sides});
        }
        if (shadows.empty()) {
            sights[k] = Seen::all;
        } else if (shadows.size() == 1) {
            if (!hide(whole, shadows.front().sides, rounding)) continue;
            sums.add(2 * k + 1, whole, -1);
            sights[k] = Seen::all_but;
        } else {
            Adding adding(are_convex_, blockers_.size(), rounding, sums, 2 * k + 1);
            adding.add(std::move(whole), {shadows.data(), shadows.size()});
            sights[k] = Seen::part;
        }
    }
    const std::span<const double> sum = sums.result();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double unoccluded = sum[2 * k];
        const double other = sum[2 * k + 1];
        const std::array visible{0.0, unoccluded, unoccluded - other, other};  // visible factor for each sight
        result[k] = {unoccluded, visible[static_cast<std::size_t>(sights[k])]};
    }
}

}  // namespace ff
