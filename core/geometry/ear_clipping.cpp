#include "core/geometry/ear_clipping.hpp"

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector2d;

/// Twice the area of a triangle; positive where it is counter-clockwise.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    const Vector2d ab = b - a;
    const Vector2d ac = c - a;
    return ab.x() * ac.y() - ab.y() * ac.x();
}

std::vector<Vector2d> seen_along_normal(const std::vector<Eigen::Vector3d>& corners) {
    const Eigen::Vector3d normal = twice_area(corners).normalized();
    const Eigen::Vector3d across = normal.unitOrthogonal();
    const Eigen::Vector3d up = normal.cross(across);
    std::vector<Vector2d> places;
    for (const Eigen::Vector3d& corner : corners)
        places.emplace_back(across.dot(corner - corners[0]), up.dot(corner - corners[0]));
    return places;
}

bool has_crossing_edges(const std::vector<Vector2d>& places) {
    const auto parts = [](const Vector2d& a, const Vector2d& b, const Vector2d& p, const Vector2d& q) {
        return turn(a, b, p) * turn(a, b, q) < 0;
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vector2d& a = places[i];
        const Vector2d& b = next_corner(places, i);
        for (std::size_t j = i + 2; j < places.size(); ++j) {
            const Vector2d& c = places[j];
            const Vector2d& d = next_corner(places, j);
            if (parts(a, b, c, d) && parts(c, d, a, b)) return true;
        }
    }
    return false;
}

/// Numbers of corners along an outline.
using Outline = std::vector<std::size_t>;

double twice_area_of(const std::vector<Vector2d>& places, const Outline& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        sum += turn(places[outline[0]], places[outline[i]], places[next_corner(outline, i)]);
    return sum;
}

/// Divides an outline where it comes back to a corner, so that each part goes round an area of its own. Holes, which
/// are gone round the other way, stay with what they are in.
std::vector<Outline> simple_parts(const std::vector<Vector2d>& places, Outline outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        for (std::size_t j = i + 1; j < outline.size(); ++j) {
            if (places[outline[i]] != places[outline[j]]) continue;
            const auto begin = outline.begin() + static_cast<std::ptrdiff_t>(i);
            const auto end = outline.begin() + static_cast<std::ptrdiff_t>(j);
            const Outline loop(begin, end);
            Outline rest(outline.begin(), begin);
            rest.insert(rest.end(), end, outline.end());
            if (twice_area_of(places, loop) < 0 || twice_area_of(places, rest) < 0) continue;
            std::vector<Outline> parts = simple_parts(places, loop);
            std::ranges::move(simple_parts(places, rest), std::back_inserter(parts));
            return parts;
        }
    }
    return {std::move(outline)};
}

/// The corners of a polygon that are left.
class Ring {
  public:
    Ring(const std::vector<Vector2d>& places, Outline outline) : places_(places), left_(std::move(outline)) {
        for (const Vector2d& place : places) flat_ = std::max(flat_, place.squaredNorm());
        constexpr double rounding = 1e-14;
        flat_ *= rounding;
        const bool is_quadrilateral = places.size() == 4;
        if (is_quadrilateral && (places[0] - places[2]).norm() < (places[1] - places[3]).norm())
            std::rotate(left_.begin(), left_.begin() + 1, left_.end());
    }

    [[nodiscard]] std::size_t size() const { return left_.size(); }
    [[nodiscard]] std::array<std::size_t, 3> around(std::size_t k) const {
        return {left_[(k + left_.size() - 1) % left_.size()], left_[k], left_[(k + 1) % left_.size()]};
    }
    [[nodiscard]] bool is_flat(std::size_t k) const {
        const auto [a, b, c] = around(k);
        return std::abs(turn(places_[a], places_[b], places_[c])) <= flat_;
    }
    [[nodiscard]] bool is_ear(std::size_t k) const {
        const auto ear = around(k);
        if (!(turn(places_[ear[0]], places_[ear[1]], places_[ear[2]]) > flat_)) return false;
        return std::none_of(left_.begin(), left_.end(), [&](std::size_t other) {
            return std::find(ear.begin(), ear.end(), other) == ear.end() && is_in_the_way(other, ear);
        });
    }
    void remove(std::size_t k) { left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k)); }

  private:
    const std::vector<Vector2d>& places_;
    Outline left_;
    double flat_ = 0;  ///< twice the area up to which three corners count as one line

    /// A corner in the same place as another one, as where a hole is joined to the rim, is not in the way.
    [[nodiscard]] bool is_in_the_way(std::size_t other, const std::array<std::size_t, 3>& ear) const {
        const Vector2d& place = places_[other];
        for (std::size_t k = 0; k < 3; ++k) {
            if (place == places_[ear[k]]) return false;
            if (turn(places_[ear[k]], places_[ear[(k + 1) % 3]], place) < 0) return false;
        }
        return true;
    }
};

}  // namespace

std::vector<std::array<std::size_t, 3>> clip_ears(const std::vector<Eigen::Vector3d>& corners) {
    const std::vector<Vector2d> places = seen_along_normal(corners);
    if (has_crossing_edges(places)) return {};
    Outline outline(places.size());
    std::iota(outline.begin(), outline.end(), std::size_t{0});
    std::vector<std::array<std::size_t, 3>> triangles;
    for (Outline& part : simple_parts(places, std::move(outline))) {
        Ring ring(places, std::move(part));
        while (ring.size() >= 3) {
            std::size_t k = 0;
            while (k < ring.size() && !ring.is_ear(k)) ++k;
            if (k < ring.size()) {
                triangles.push_back(ring.around(k));
            } else {
                for (k = 0; k < ring.size() && !ring.is_flat(k);) ++k;
                if (k == ring.size()) return {};
            }
            ring.remove(k);
        }
    }
    return triangles;
}

std::vector<Eigen::Vector3d> without_spikes(std::vector<Eigen::Vector3d> corners) {
    constexpr double rounding = 1e-9;
    for (std::size_t k = 0; k < corners.size() && corners.size() > 3;) {
        const std::size_t before = (k + corners.size() - 1) % corners.size();
        const Eigen::Vector3d here = corners[k] - corners[before];
        const Eigen::Vector3d onwards = next_corner(corners, k) - corners[k];
        if (here.dot(onwards) < 0 && here.cross(onwards).norm() <= rounding * here.norm() * onwards.norm()) {
            // Where the outline comes back to the same place, one of both goes.
            const bool is_same = next_corner(corners, k) == corners[before];
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
            if (is_same) corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(before > k ? before - 1 : before));
            k = 0;
        } else {
            ++k;
        }
    }
    return corners;
}

}  // namespace ff
