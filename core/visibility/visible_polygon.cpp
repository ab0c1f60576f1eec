#include "core/visibility/visible_polygon.hpp"

#include "core/formulas/arc_terms.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/support/contract.hpp"

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numbers>
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

/// The part of a convex polygon where sign * height >= 0; none of less than three corners.
SmallPolygon part_of(const SmallPolygon& polygon, const Heights& heights, double sign) {
    SmallPolygon part;
    part.resize(polygon.size() + 2, boost::container::default_init);
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

/// Heights above a plane through the origin. @return whether some are below
bool find_heights(const SmallPolygon& polygon, const Vector3d& normal, Heights& heights) {
    heights.resize(polygon.size(), boost::container::default_init);
    bool some_below = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        heights[k] = normal.dot(polygon[k]);
        some_below = some_below || heights[k] < 0;
    }
    return some_below;
}

/// Takes the part where normal * v < 0 off a convex polygon. @return whether there is one; what is left may be empty
bool cut(SmallPolygon& polygon, const Vector3d& normal) {
    Heights heights;
    if (!find_heights(polygon, normal, heights)) return false;
    polygon = part_of(polygon, heights, 1);
    return true;
}

/// The same. @return that part
SmallPolygon cut_off(SmallPolygon& polygon, const Vector3d& normal) {
    Heights heights;
    if (!find_heights(polygon, normal, heights)) return {};
    SmallPolygon off = part_of(polygon, heights, -1);
    polygon = part_of(polygon, heights, 1);
    return off;
}

/// From so many blockers on it pays to ask first which of them are beside the target.
constexpr std::size_t least_for_cone = 3;

/// Room for the rounding of a triple product, relative to the lengths of its factors.
constexpr double product_rounding = 4e-15;

/// Planes through the origin and the edges of a polygon, normals towards its inside; none where it is seen edge-on, or
/// so nearly that rounding decides where its inside is.
void find_sides(const SmallPolygon& polygon, SmallPolygon& sides) {
    sides.clear();
    Vector3d middle = Vector3d::Zero();
    Heights squares;
    for (const Vector3d& corner : polygon) {
        middle += corner;
        squares.push_back(product_rounding * corner.squaredNorm());
    }
    const double farthest = middle.squaredNorm();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vector3d side = polygon[k].cross(next_corner(polygon, k));
        const double room = squares[k] * next_corner(squares, k);
        if (side.squaredNorm() <= room) continue;  // two corners in one
        const double height = side.dot(middle);
        if (height * height <= room * farthest) return sides.clear();
        sides.push_back(height > 0 ? side : -side);
    }
    if (sides.size() < 3) sides.clear();
}

bool is_outside(const SmallPolygon& piece, const SmallPolygon& sides) {
    return std::any_of(sides.begin(), sides.end(), [&](const Vector3d& side) {
        return std::all_of(piece.begin(), piece.end(), [&](const Vector3d& v) { return side.dot(v) <= 0; });
    });
}

/// Leaves out sides of a shadow that all of a piece is inside of. @return whether some of the piece may be in the
/// shadow
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
        if (some_outside) sides[kept++] = sides[k];
    }
    sides.resize(kept);
    return true;
}

/// Adds up Lambert's formula for pieces of what is seen from several places, many edges at a time.
class Sums {
  public:
    Sums(Vector3d normal, std::size_t places) : normal_(std::move(normal)), sums_(places, 0.0) {}

    /// @param sign  of its factor in the sum of a place
    void add(std::size_t place, const SmallPolygon& piece, double sign) {
        for (std::size_t k = 0; k < piece.size(); ++k) {
            if (arcs_.is_full()) flush();
            of_[arcs_.size] = {static_cast<std::uint32_t>(place), sign};
            arcs_.add(piece[k], next_corner(piece, k));
        }
    }

    /// By place.
    [[nodiscard]] std::span<const double> result() {
        flush();
        return {sums_.data(), sums_.size()};
    }

  private:
    struct Owner {
        std::uint32_t place;
        double sign;
    };
    Vector3d normal_;
    boost::container::small_vector<double, 64> sums_;
    Arcs arcs_;
    std::array<Owner, Arcs::capacity> of_;

    void flush() {
        std::array<double, Arcs::capacity> terms;
        find_arc_terms(arcs_, normal_, terms);
        for (std::size_t k = 0; k < arcs_.size; ++k)
            sums_[of_[k].place] += of_[k].sign * terms[k] * (0.5 / std::numbers::pi);
        arcs_.size = 0;
    }
};

/// What of a convex piece a shadow hides, given by the planes of its sides: all of it where it does not differ.
bool hide(SmallPolygon& piece, const SmallPolygon& shadow) {
    bool differs = false;
    for (const Vector3d& side : shadow) {
        differs = cut(piece, side) || differs;
        if (piece.empty()) break;
    }
    return differs;
}

/// Adds the part of a convex piece that no shadow hides.
void add_visible(Sums& sums, std::size_t place, SmallPolygon piece, std::span<const SmallPolygon> shadows,
                 double sign) {
    while (!shadows.empty() && is_outside(piece, shadows.front())) shadows = shadows.subspan(1);
    if (shadows.empty()) return sums.add(place, piece, sign);
    if (shadows.size() == 1) {
        SmallPolygon hidden = piece;
        if (!hide(hidden, shadows.front())) return;
        sums.add(place, piece, sign);
        return sums.add(place, hidden, -sign);
    }
    for (const Vector3d& side : shadows.front()) {
        SmallPolygon outside = cut_off(piece, side);
        if (!outside.empty()) add_visible(sums, place, std::move(outside), shadows.subspan(1), sign);
        if (piece.empty()) break;
    }
}

}  // namespace

VisiblePolygon::VisiblePolygon(const Surface& target, const std::vector<const Surface*>& blockers)
    : target_(outline(target)), target_normal_(target.normal) {
    FF_EXPECT(!target_.empty());
    // Parts of blockers that lie behind the target's plane hide nothing.
    const Vector3d origin = target_.front();
    for (const Surface* blocker : blockers) {
        FF_EXPECT(!corners(blocker->shape).empty());
        SmallPolygon part;
        see_from(origin, outline(*blocker), part);
        cut(part, target_normal_);
        std::vector<Vector3d>& kept = blockers_.emplace_back();
        for (const Vector3d& corner : part) kept.emplace_back(origin + corner);
    }
    all_.resize(blockers_.size());
    std::iota(all_.begin(), all_.end(), 0U);
}

VisiblePolygon::Factors VisiblePolygon::from(const Vector3d& place, const Vector3d& normal) const {
    return from(place, normal, all_);
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
    Sums sums(normal, 2 * places.size());
    enum class Sight : std::uint8_t { nothing, all, all_but, part };
    boost::container::small_vector<Sight, 32> sights(places.size(), Sight::nothing);
    SmallPolygon whole;
    SmallPolygon cone;
    SmallPolygon blocker;
    SmallPolygon sides;
    boost::container::small_vector<SmallPolygon, 4> shadows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Vector3d& place = places[k];
        if (target_normal_.dot(target_.front() - place) >= 0) continue;
        see_from(place, target_, whole);
        cut(whole, normal);
        if (whole.empty()) continue;
        // Corners run clockwise as seen from the place that the polygon's normal points to.
        sums.add(2 * k, whole, -1);
        if (blockers.size() >= least_for_cone) find_sides(whole, cone);
        shadows.clear();
        for (const std::uint32_t index : blockers) {
            see_from(place, blockers_[index], blocker);
            if (is_outside(blocker, cone)) continue;
            cut(blocker, normal);
            if (blocker.empty()) continue;
            find_sides(blocker, sides);
            if (!sides.empty() && keep_those_that_cut(sides, whole)) shadows.push_back(sides);
        }
        if (shadows.empty()) {
            sights[k] = Sight::all;
        } else if (shadows.size() == 1) {
            if (!hide(whole, shadows.front())) continue;
            sums.add(2 * k + 1, whole, -1);
            sights[k] = Sight::all_but;
        } else {
            add_visible(sums, 2 * k + 1, std::move(whole), {shadows.data(), shadows.size()}, -1);
            sights[k] = Sight::part;
        }
    }
    const std::span<const double> sum = sums.result();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double other = sum[2 * k + 1];
        result[k].whole = sum[2 * k];
        switch (sights[k]) {
            case Sight::nothing:
                result[k].visible = 0;
                break;
            case Sight::all:
                result[k].visible = result[k].whole;
                break;
            case Sight::all_but:
                result[k].visible = result[k].whole - other;
                break;
            case Sight::part:
                result[k].visible = other;
                break;
        }
    }
}

}  // namespace ff
