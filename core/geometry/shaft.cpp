#include "core/geometry/shaft.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <limits>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Room for rounding, relative to what is compared.
constexpr double tolerance = 1e-15;

/// Edges whose angle has a smaller sine span no plane; what is inside by a smaller share may be at the rim.
constexpr double least_sine = 1e-9;

struct Range {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();

    void include(const std::vector<Vector3d>& points, const Vector3d& axis) {
        for (const Vector3d& point : points) {
            const double at = axis.dot(point);
            low = std::min(low, at);
            high = std::max(high, at);
        }
    }
};

}  // namespace

Shaft::Shaft(const std::vector<Vector3d>& from, const ConvexPolygon& to) : from_(from), to_(to) {
    for (const ConvexPolygon* ends : {&from_, &to_}) {
        for (const Vector3d& end : *ends) size_ = std::max(size_, 2 * (end - from_.front()).lpNorm<1>());
    }
}

bool Shaft::is_parted(const ConvexPolygon& polygon, const Vector3d& axis) const {
    Range own;
    own.include(polygon, axis);
    Range lines;
    lines.include(from_, axis);
    // Most planes part nothing, and the beginnings of lines often show it.
    const double most_room = tolerance * std::max(size_ * axis.lpNorm<1>(), own.high - own.low);
    if (own.low < lines.high - most_room && own.high > lines.low + most_room) return false;
    lines.include(to_, axis);
    const double room = tolerance * std::max(lines.high - lines.low, own.high - own.low);
    return own.low >= lines.high - room || own.high <= lines.low + room;
}

bool Shaft::is_parted(const ConvexPolygon& polygon, const Vector3d& line, const Vector3d& edge) const {
    const Vector3d axis = line.cross(edge);
    if (axis.squaredNorm() <= least_sine * least_sine * line.squaredNorm() * edge.squaredNorm()) return false;
    return is_parted(polygon, axis);
}

Shaft::Crossing Shaft::crossed_by(const ConvexPolygon& polygon) const {
    const Vector3d normal = twice_area(polygon);
    for (const Vector3d& across : {normal, twice_area(to_)}) {
        if (across.squaredNorm() > 0 && is_parted(polygon, across)) return Crossing::none;
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (is_parted(polygon, Vector3d::Unit(axis))) return Crossing::none;
    }
    // Lines that cross it show, at less cost, that no plane parts it.
    const Crossing shown = crossed_between_corners(polygon, normal);
    return shown == Crossing::none && !is_parted_along_an_edge(polygon) ? Crossing::some : shown;
}

Shaft::Crossing Shaft::crossed_between_corners(const ConvexPolygon& polygon, const Vector3d& normal) const {
    boost::container::small_vector<Vector3d, 8> inward;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        inward.push_back(normal.cross(next_corner(polygon, k) - polygon[k]));
    const double plane = normal.dot(polygon.front());
    const auto height = [&](const Vector3d& place) { return normal.dot(place) - plane; };
    const double side = height(from_.front());
    const double well_inside = least_sine * normal.squaredNorm();
    bool all = true;
    bool some = false;
    for (const Vector3d& begin : from_) {
        const double before = height(begin);
        for (const Vector3d& end : to_) {
            const double after = height(end);
            double inside = std::numeric_limits<double>::lowest();
            if (before * after < 0) {
                const Vector3d crossing = begin + (end - begin) * (before / (before - after));
                inside = std::numeric_limits<double>::max();
                for (std::size_t k = 0; k < polygon.size(); ++k)
                    inside = std::min(inside, inward[k].dot(crossing - polygon[k]));
            }
            all = all && before * side > 0 && inside >= 0;
            some = some || inside > well_inside;
            if (some && !all) return Crossing::some;
        }
    }
    return all ? Crossing::all : Crossing::none;
}

bool Shaft::is_parted_along_an_edge(const ConvexPolygon& polygon) const {
    for (const Vector3d& begin : from_) {
        for (std::size_t t = 0; t < to_.size(); ++t) {
            const Vector3d line = to_[t] - begin;
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                if (is_parted(polygon, line, next_corner(polygon, k) - polygon[k])) return true;
            }
            if (is_parted(polygon, line, next_corner(to_, t) - to_[t])) return true;
        }
    }
    for (std::size_t k = 0; k < from_.size(); ++k) {
        const Vector3d edge = next_corner(from_, k) - from_[k];
        for (const Vector3d& end : to_) {
            if (is_parted(polygon, end - from_[k], edge)) return true;
        }
    }
    return false;
}

}  // namespace ff
