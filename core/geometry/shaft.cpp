#include "core/geometry/shaft.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Gaps of this share of the smallest thing that a proof is about count as none.
constexpr double gap_of_grain = 1e-15;

/// What a length may be off by, as a share of the longest that it was made from.
constexpr double noise_of_size = 5e-16;

/// Edges that are shorter, as a share of a polygon's size, have no direction; nor have axes of that sine.
constexpr double least_sine = 1e-9;

struct Range {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();

    void include(std::span<const Vector3d> points, const Vector3d& axis, const Vector3d& origin) {
        for (const Vector3d& point : points) {
            const double at = axis.dot(point - origin);
            low = std::min(low, at);
            high = std::max(high, at);
        }
    }
};

double size_of(std::span<const Vector3d> corners) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& corner : corners) box.extend(corner);
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

}  // namespace

Plate::Plate(const ConvexPolygon& polygon)
    : corners_(polygon.begin(), polygon.end()),
      normal_(twice_area(polygon).normalized()),
      size_(size_of(polygon)),
      slenderness_(std::max(1.0, size_ * size_ / twice_area(polygon).norm())) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d along = next_corner(polygon, k) - polygon[k];
        if (along.norm() > least_sine * size_) edges_.push_back({polygon[k], normal_.cross(along).normalized()});
    }
}

Shaft::Shaft(std::span<const Vector3d> from, std::span<const Vector3d> to, double grain) : from_(from), to_(to) {
    FF_EXPECT(from.size() + to.size() <= most_corners);
    for (const std::span<const Vector3d> end : {from, to}) {
        for (const Vector3d& corner : end) corners_[count_++] = corner;
    }
    size_ = size_of({corners_.data(), count_});
    grain_ = grain > 0 ? grain : size_;
}

Shaft::Slack Shaft::slack(const Plate& plate) const {
    const double noise = noise_of_size * std::max(size_, plate.size_) * plate.slenderness_;
    return {noise, gap_of_grain * grain_ - noise};
}

Shaft::Crossing Shaft::crossed_by(const Plate& plate) const {
    const auto [noise, gap] = slack(plate);
    /// 1 / height of each corner above the plane; 0 for those in it.
    std::array<double, most_corners> inverse{};
    bool before = false;
    bool behind = false;
    bool apart = true;  // each end on a side of its own
    for (std::size_t k = 0; k < count_; ++k) {
        const double height = plate.normal_.dot(corners_[k] - plate.corners_.front());
        const bool is_in_plane = !(std::abs(height) > noise);
        inverse[k] = is_in_plane ? 0 : 1 / height;
        before = before || inverse[k] > 0;
        behind = behind || inverse[k] < 0;
        apart = apart && !is_in_plane && (k == 0 || (inverse[k] > 0) == ((k < from_.size()) == (inverse[0] > 0)));
    }
    if (!before || !behind) return Crossing::none;
    bool all = apart;
    for (const Plate::Edge& edge : plate.edges_) {
        // Between a corner before the plane and one behind it, a line crosses the plane outside of the edge where the
        // first has the smaller ratio of the distances from both.
        Range before_gap;
        Range behind_gap;
        Range before_edge;
        Range behind_edge;
        bool reaches_in = false;
        for (std::size_t k = 0; k < count_; ++k) {
            const double inside = edge.inward.dot(corners_[k] - edge.corner);
            const double beyond_gap = inside == 0 ? 0 : inside - gap;
            if (inverse[k] == 0) {
                reaches_in = reaches_in || beyond_gap > 0;
                continue;
            }
            Range& of_gap = inverse[k] > 0 ? before_gap : behind_gap;
            Range& of_edge = inverse[k] > 0 ? before_edge : behind_edge;
            of_gap.high = std::max(of_gap.high, beyond_gap * inverse[k]);
            of_gap.low = std::min(of_gap.low, beyond_gap * inverse[k]);
            of_edge.low = std::min(of_edge.low, inside * inverse[k]);
            of_edge.high = std::max(of_edge.high, inside * inverse[k]);
        }
        if (!reaches_in && before_gap.high <= behind_gap.low) return Crossing::none;
        all = all && before_edge.low >= behind_edge.high;
    }
    return all ? Crossing::all : Crossing::some;
}

void Shaft::find_sides() {
    const auto add = [&](const Vector3d& at, Vector3d out, double longest) {
        if (!(out.norm() > least_sine * longest)) return;
        out.normalize();
        Range lines;
        lines.include({corners_.data(), count_}, out, corners_[0]);
        const double height = out.dot(at - corners_[0]);
        const double room = 8 * noise_of_size * size_;
        if (lines.high <= height + room) sides_.push_back({out, lines.high});
        if (lines.low >= height - room) sides_.push_back({-out, -lines.low});
    };
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Range lines;
        lines.include({corners_.data(), count_}, Vector3d::Unit(axis), corners_[0]);
        sides_.push_back({Vector3d::Unit(axis), lines.high});
        sides_.push_back({-Vector3d::Unit(axis), -lines.low});
    }
    const std::span<const Vector3d> ends[] = {from_, to_};
    for (const bool first : {true, false}) {
        const std::span<const Vector3d> edges = ends[first ? 0 : 1];
        const Vector3d across = (edges[1] - edges[0]).cross(edges.back() - edges[0]);
        add(edges[0], across, across.norm());
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const Vector3d edge = edges[k + 1 == edges.size() ? 0 : k + 1] - edges[k];
            for (const Vector3d& other : ends[first ? 1 : 0]) {
                const Vector3d line = other - edges[k];
                add(edges[k], edge.cross(line), edge.norm() * line.norm());
            }
        }
    }
}

Shaft::Crossing Shaft::crossed_by_inside(const Plate& plate) {
    const Crossing crossing = crossed_by(plate);
    if (crossing != Crossing::some) return crossing;
    if (sides_.empty()) find_sides();
    const double gap = slack(plate).gap;
    for (const auto& [out, height] : sides_) {
        Range own;
        own.include({plate.corners_.data(), plate.corners_.size()}, out, corners_[0]);
        if (own.low == height || own.low >= height - gap) return Crossing::none;
    }
    return Crossing::some;
}

}  // namespace ff
