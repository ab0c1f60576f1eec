#include "core/geometry/shaft.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/geometry/shaft.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/support/double_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One number for each corner of a shaft, in rows of eight.
using ByCorner = std::array<Doubles, Shaft::most_corners / lanes>;

/// Distances from a plane or an edge.
HWY_INLINE void find_distances(const Shaft::Corners& corners, const Eigen::Vector3d& along,
                               const Eigen::Vector3d& origin, ByCorner& result) {
    const DoubleTag d;
    for (std::size_t k = 0; k < corners.count / lanes; ++k) {
        const auto x = hn::Sub(hn::Load(d, &corners.x[k * lanes]), constant(origin.x()));
        const auto y = hn::Sub(hn::Load(d, &corners.y[k * lanes]), constant(origin.y()));
        const auto z = hn::Sub(hn::Load(d, &corners.z[k * lanes]), constant(origin.z()));
        result[k] = hn::Add(hn::Add(hn::Mul(x, constant(along.x())), hn::Mul(y, constant(along.y()))),
                            hn::Mul(z, constant(along.z())));
    }
}

HWY_INLINE double highest(Doubles values) {
    return hn::GetLane(hn::MaxOfLanes(DoubleTag(), values));
}

HWY_INLINE double lowest(Doubles values) {
    return hn::GetLane(hn::MinOfLanes(DoubleTag(), values));
}

/// The least and the greatest height of all corners above the first one.
std::pair<double, double> reach(const Shaft::Corners& corners, const Eigen::Vector3d& along) {
    ByCorner heights;
    find_distances(corners, along, {corners.x[0], corners.y[0], corners.z[0]}, heights);
    auto low = constant(std::numeric_limits<double>::infinity());
    auto high = hn::Neg(low);
    for (std::size_t k = 0; k < corners.count / lanes; ++k) {
        low = hn::Min(low, heights[k]);
        high = hn::Max(high, heights[k]);
    }
    return {lowest(low), highest(high)};
}

/// @param open  where not null: bits of edges that some lines pass outside, or may
Shaft::Crossing crossing(const Shaft::Corners& corners, const Plate& plate, Shaft::Slack slack, std::uint32_t* open) {
    const DoubleTag d;
    const auto far = constant(std::numeric_limits<double>::infinity());
    const auto zero = hn::Zero(d);
    const std::size_t vectors_of_corners = corners.count / lanes;
    ByCorner inverse;  // 1 / height of each corner above the plane; 0 for those in it
    find_distances(corners, plate.normal, plate.corners.front(), inverse);
    auto most = zero;
    auto least = zero;
    auto ends_before = far;  // above 0 where `from` is before the plane and `to` behind it
    auto ends_behind = hn::Neg(far);
    for (std::size_t k = 0; k < vectors_of_corners; ++k) {
        const auto apart = hn::Gt(hn::Abs(inverse[k]), constant(slack.noise));
        inverse[k] = hn::IfThenElseZero(apart, hn::Div(constant(1), inverse[k]));
        most = hn::Max(most, inverse[k]);
        least = hn::Min(least, inverse[k]);
        const auto turned = hn::Mul(inverse[k], hn::Load(d, &corners.end[k * lanes]));
        ends_before = hn::Min(ends_before, turned);
        ends_behind = hn::Max(ends_behind, turned);
    }
    if (!(highest(most) > 0) || !(lowest(least) < 0)) return Shaft::Crossing::none;
    bool all = lowest(ends_before) > 0 || highest(ends_behind) < 0;  // every line crosses, within all edges so far
    ByCorner inside;
    for (const Plate::Edge& edge : plate.edges) {
        find_distances(corners, edge.inward, edge.corner, inside);
        // Between a corner before the plane and one behind it, a line crosses the plane outside of the edge where the
        // first has the smaller ratio of the distances from both.
        auto highest_before = hn::Neg(far);
        auto lowest_before = far;
        auto highest_behind = hn::Neg(far);
        auto lowest_behind = far;
        auto reach_in_plane = zero;
        auto lack_in_plane = zero;
        for (std::size_t k = 0; k < vectors_of_corners; ++k) {
            const auto before = hn::Gt(inverse[k], zero);
            const auto behind = hn::Lt(inverse[k], zero);
            const auto beyond_gap =
                hn::IfThenZeroElse(hn::Eq(inside[k], zero), hn::Sub(inside[k], constant(slack.gap)));
            const auto of_gap = hn::Mul(beyond_gap, inverse[k]);
            const auto of_edge = hn::Mul(inside[k], inverse[k]);
            highest_before = hn::Max(highest_before, hn::IfThenElse(before, of_gap, hn::Neg(far)));
            lowest_behind = hn::Min(lowest_behind, hn::IfThenElse(behind, of_gap, far));
            lowest_before = hn::Min(lowest_before, hn::IfThenElse(before, of_edge, far));
            highest_behind = hn::Max(highest_behind, hn::IfThenElse(behind, of_edge, hn::Neg(far)));
            const auto in_plane = hn::Eq(inverse[k], zero);
            reach_in_plane = hn::Max(reach_in_plane, hn::IfThenElseZero(in_plane, beyond_gap));
            lack_in_plane = hn::Min(lack_in_plane, hn::IfThenElseZero(in_plane, inside[k]));
        }
        if (highest(highest_before) <= lowest(lowest_behind) && !(highest(reach_in_plane) > 0))
            return Shaft::Crossing::none;
        if (!all && open == nullptr) continue;
        const bool is_inside = lowest(lowest_before) >= highest(highest_behind);
        all = all && is_inside;
        if (open != nullptr && is_inside && !(lowest(lack_in_plane) < 0)) *open &= ~(1U << edge.index);
    }
    return all ? Shaft::Crossing::all : Shaft::Crossing::some;
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {

HWY_EXPORT(crossing);
HWY_EXPORT(reach);

namespace {

using Eigen::Vector3d;

/// Gaps of this share of the smallest thing that a proof is about do not count.
constexpr double gap_of_grain = 1e-15;

/// Possible error of a length, as a share of the longest length that it was computed from.
constexpr double noise_of_size = 5e-16;

/// Edges that are shorter, as a share of a polygon's size, have no direction; nor have axes of that sine.
constexpr double least_sine = 1e-9;

}  // namespace

Plate::Plate(const ConvexPolygon& polygon)
    : corners(polygon),
      normal(twice_area(polygon).normalized()),
      size(polygon.empty() ? 0 : box_around(polygon).sizes().maxCoeff()),
      slenderness(std::max(1.0, size * size / twice_area(polygon).norm())) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d along = next_corner(polygon, k) - polygon[k];
        if (along.norm() > least_sine * size) edges.push_back({polygon[k], normal.cross(along).normalized(), k});
    }
}

Shaft::Shaft(std::span<const Vector3d> from, std::span<const Vector3d> to, double grain) : from_(from), to_(to) {
    FF_EXPECT(!from.empty() && !to.empty() && from.size() + to.size() <= most_corners);
    Eigen::AlignedBox3d box;
    const auto add = [&](const Vector3d& corner, double end) {
        const std::size_t k = corners_.count++;
        corners_.x[k] = corner.x();
        corners_.y[k] = corner.y();
        corners_.z[k] = corner.z();
        corners_.end[k] = end;
        box.extend(corner);
    };
    for (const Vector3d& corner : from) add(corner, 1);
    for (const Vector3d& corner : to) add(corner, -1);
    while (corners_.count % 8 != 0) add(to.back(), -1);
    size_ = box.sizes().maxCoeff();
    grain_ = grain > 0 ? grain : size_;
}

Shaft::Slack Shaft::slack(const Plate& plate) const {
    const double noise = noise_of_size * std::max(size_, plate.size) * plate.slenderness;
    return {noise, gap_of_grain * grain_ - noise};
}

Shaft::Crossing Shaft::crossed_by(const Plate& plate) const {
    return HWY_DYNAMIC_DISPATCH(crossing)(corners_, plate, slack(plate), nullptr);
}

std::uint32_t Shaft::open_edges(const Plate& plate) const {
    std::uint32_t open = ~std::uint32_t{0};
    HWY_DYNAMIC_DISPATCH(crossing)(corners_, plate, slack(plate), &open);
    return open;
}

void Shaft::add_side(const Vector3d& at, const Vector3d& out) {
    const double room = 8 * noise_of_size * size_;
    const double height = out.dot(at - corner(0));
    const auto [low, high] = HWY_DYNAMIC_DISPATCH(reach)(corners_, out);
    if (high <= height + room) sides_.push_back({out, high});
    if (low >= height - room) sides_.push_back({-out, -low});
}

void Shaft::find_sides() {
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < corners_.count; ++k) box.extend(corner(k));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        sides_.push_back({Vector3d::Unit(axis), box.max()[axis] - corner(0)[axis]});
        sides_.push_back({-Vector3d::Unit(axis), corner(0)[axis] - box.min()[axis]});
    }
    const std::array ends{from_, to_};
    for (const bool first : {true, false}) {
        const std::span<const Vector3d> edges = ends[first ? 0 : 1];
        const Vector3d across = (edges[1] - edges[0]).cross(edges.back() - edges[0]);
        if (across.squaredNorm() > 0) add_side(edges[0], across.normalized());
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const Vector3d edge = edges[k + 1 == edges.size() ? 0 : k + 1] - edges[k];
            for (const Vector3d& other : ends[first ? 1 : 0]) {
                const Vector3d line = other - edges[k];
                const Vector3d out = edge.cross(line);
                const double square = out.squaredNorm();
                if (square > least_sine * least_sine * edge.squaredNorm() * line.squaredNorm())
                    add_side(edges[k], out / std::sqrt(square));
            }
        }
    }
}

bool Shaft::is_beside(const Plate& plate) {
    if (sides_.empty()) find_sides();
    const double gap = slack(plate).gap;
    const Vector3d origin = corner(0);
    return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
        double low = std::numeric_limits<double>::max();
        for (const Vector3d& place : plate.corners) low = std::min(low, side.out.dot(place - origin));
        return low == side.height || low >= side.height - gap;
    });
}

}  // namespace ff
#endif  // HWY_ONCE
