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

/// Up to so many shadows, it takes less time to cut pieces out than to outline what is left.
constexpr std::size_t most_in_pieces = 2;

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
bool is_outside(const SmallPolygon& piece, const SmallPolygon& sides, double room) {
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

/// The sides of shadows.
using Shadows = boost::container::small_vector<SmallPolygon, 4>;

/// Adds the part of a convex piece that no shadow hides. What a shadow hides is taken off the sum where no other one
/// hides any of that; else the piece is cut up along the shadow's sides.
// NOLINTNEXTLINE(misc-no-recursion): each level has fewer shadows.
void add_visible(SmallPolygon piece, std::span<const SmallPolygon> shadows, double rounding, std::size_t place,
                 ArcSums& sums) {
    for (; !shadows.empty(); shadows = shadows.subspan(1)) {
        const SmallPolygon& shadow = shadows.front();
        const std::span<const SmallPolygon> others = shadows.subspan(1);
        if (is_outside(piece, shadow, rounding)) continue;
        SmallPolygon hidden = piece;
        if (!hide(hidden, shadow, rounding)) return;
        if (hidden.empty()) continue;
        const auto overlaps = [&](const SmallPolygon& other) { return !is_outside(hidden, other, rounding); };
        if (std::any_of(others.begin(), others.end(), overlaps)) {
            for (const Vector3d& side : shadow) {
                SmallPolygon outside;
                cut(piece, side, rounding, &outside);
                if (!outside.empty()) add_visible(std::move(outside), others, rounding, place, sums);
                if (piece.empty()) break;
            }
            return;
        }
        sums.add(place, hidden, 1);
    }
    sums.add(place, piece, -1);
}

/// Corners that are next to each other within rounding become one.
void join_corners(SmallPolygon& polygon, double rounding) {
    const double shortest = roundings_of_edge * rounding;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& last = kept > 0 ? polygon[kept - 1] : polygon.back();
        if ((polygon[k] - last).squaredNorm() > shortest * shortest) polygon[kept++] = polygon[k];
    }
    polygon.resize(kept < 3 ? 0 : kept);
}

}  // namespace

VisiblePolygon::VisiblePolygon(const Surface& target, const std::vector<Blocker>& blockers, FacedEnd place_at)
    : target_(outline(target)),
      target_normal_(target.normal),
      blockers_(parts_before_target(blockers)),
      edges_(blockers_, rounding_) {
    for (const Blocker& blocker : blockers) {
        hides_.push_back(blocker.faces == FacedEnd::either ? Hides::always
                         : blocker.faces == place_at       ? Hides::from_before
                                                           : Hides::from_behind);
    }
    all_.resize(blockers_.size());
    std::iota(all_.begin(), all_.end(), 0U);
}

/// Those that lie behind the target's plane hide nothing.
std::vector<ConvexPolygon> VisiblePolygon::parts_before_target(const std::vector<Blocker>& blockers) {
    FF_EXPECT(!target_.empty());
    const Vector3d origin = target_.front();
    const auto allow_for = [&](const ConvexPolygon& polygon) {
        for (const Vector3d& corner : polygon)
            rounding_ = std::max(rounding_, coordinate_rounding * corner.lpNorm<Eigen::Infinity>());
    };
    allow_for(target_);
    for (const Blocker& blocker : blockers) allow_for(corners(blocker.surface->shape));
    std::vector<ConvexPolygon> result;
    for (const Blocker& blocker : blockers) {
        FF_EXPECT(is_polygon(blocker.surface->shape));
        SmallPolygon part;
        see_from(origin, outline(*blocker.surface), part);
        cut(part, target_normal_, rounding_);
        join_corners(part, rounding_);
        std::vector<Vector3d>& kept = result.emplace_back();
        for (const Vector3d& corner : part) kept.emplace_back(origin + corner);
    }
    return result;
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
    // Two sums for each place: of the whole, and of what is seen of it.
    ArcSums sums(normal, 2 * places.size());
    enum class Seen : std::uint8_t { nothing, all, all_but, part };
    boost::container::small_vector<Seen, 32> sights(places.size(), Seen::nothing);
    ShadowEdges::Scratch scratch;
    std::vector<ShadowEdges::Side> sides(blockers_.size());
    boost::container::small_vector<std::uint32_t, 32> seen_blockers;
    Shadows shadows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Vector3d& place = places[k];
        if (target_normal_.dot(target_.front() - place) >= 0) continue;
        const double rounding = std::max(rounding_, coordinate_rounding * place.lpNorm<Eigen::Infinity>());
        SmallPolygon whole;
        see_from(place, target_, whole);
        if (cut(whole, normal, rounding)) join_corners(whole, rounding);
        if (whole.empty()) continue;
        // Corners run clockwise as seen from the place that the polygon's normal points to.
        sums.add(2 * k, whole, -1);
        seen_blockers.clear();
        for (const std::uint32_t index : blockers) {
            const ShadowEdges::Side side = edges_.side(index, place);
            const bool hides = hides_[index] == Hides::always ||
                               hides_[index] == (side == ShadowEdges::front ? Hides::from_before : Hides::from_behind);
            sides[index] = hides ? side : ShadowEdges::Side{0};
            if (sides[index] != 0 && !blockers_[index].empty()) seen_blockers.push_back(index);
        }
        if (seen_blockers.size() > most_in_pieces) {
            using Sees = ShadowEdges::Sees;
            const Sees sees = edges_.find(place, sides, {whole.data(), whole.size()}, target_normal_, scratch);
            for (const ShadowEdges::Arc& arc : scratch.outline) sums.add(2 * k + 1, arc.begin, arc.end, -1);
            sights[k] = sees == Sees::all ? Seen::all : sees == Sees::part ? Seen::part : Seen::nothing;
            if (sees != Sees::unclear) continue;
        }
        shadows.clear();
        for (const std::uint32_t index : seen_blockers) {
            SmallPolygon blocker;
            see_from(place, blockers_[index], blocker);
            cut(blocker, normal, rounding);
            SmallPolygon& shadow = shadows.emplace_back();
            find_sides(blocker, rounding, shadow);
            if (shadow.empty() || !keep_those_that_cut(shadow, whole)) shadows.pop_back();
        }
        if (shadows.empty()) {
            sights[k] = Seen::all;
        } else if (shadows.size() == 1) {
            if (!hide(whole, shadows.front(), rounding)) continue;
            sums.add(2 * k + 1, whole, -1);
            sights[k] = Seen::all_but;
        } else {
            add_visible(std::move(whole), {shadows.data(), shadows.size()}, rounding, 2 * k + 1, sums);
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
