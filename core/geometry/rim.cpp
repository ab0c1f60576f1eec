#include "core/geometry/rim.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace ff {
namespace {

using Eigen::Vector3d;

/// The place that three planes have in common; empty where they have none, or more than one.
std::optional<Vector3d> common_place(const LidPlane& a, const LidPlane& b, const LidPlane& c) {
    Eigen::Matrix3d normals;
    normals << a.normal().transpose(), b.normal().transpose(), c.normal().transpose();
    const auto solver = normals.fullPivLu();
    if (!solver.isInvertible()) return std::nullopt;
    return solver.solve(Vector3d(-a.offset(), -b.offset(), -c.offset()));
}

/// The places at which a polygon in plane `here` turns between those at which it meets the planes `first` and `last`.
std::vector<Vector3d> corners_between(const std::vector<LidPlane>& planes, std::size_t here, std::size_t first,
                                      std::size_t last) {
    if (first == last) return {};
    if (const auto corner = common_place(planes[here], planes[first], planes[last])) return {*corner};
    // Opposite walls: a third one runs from one to the other.
    for (std::size_t other = 0; other < planes.size(); ++other) {
        const auto begin = common_place(planes[here], planes[first], planes[other]);
        const auto end = common_place(planes[here], planes[other], planes[last]);
        if (begin && end) return {*begin, *end};
    }
    return {};
}

}  // namespace

std::vector<ConvexPolygon> closing_polygons(const ConvexPolygon& rim, const std::vector<LidPlane>& planes, double gap) {
    const std::size_t n = rim.size();
    if (n == 0) return {};
    const auto lies_in = [&](std::size_t plane, const Vector3d& place) {
        return planes[plane].absDistance(place) <= gap;
    };
    const auto plane_of_edge = [&](const Vector3d& a, const Vector3d& b) {
        std::size_t plane = 0;
        while (plane + 1 < planes.size() && !(lies_in(plane, a) && lies_in(plane, b))) ++plane;
        return plane;
    };
    std::vector<ConvexPolygon> all;
    Vector3d missing = twice_area(rim);  // as vectors, areas of polygons that close a rim have the sum of its own
    for (std::size_t here = 0; here < planes.size(); ++here) {
        ConvexPolygon& lid = all.emplace_back();
        // Begins where the rim comes back into the plane, so that each way out of it is followed by one back.
        std::size_t begin = 0;
        while (begin < n && !(lies_in(here, rim[begin]) && !lies_in(here, rim[(begin + n - 1) % n]))) ++begin;
        std::size_t left_along = here;
        for (std::size_t k = begin; k <= begin + n; ++k) {
            const Vector3d& corner = rim[k % n];
            const Vector3d& next = rim[(k + 1) % n];
            if (!lies_in(here, corner)) continue;
            const Vector3d& before = rim[(k + n - 1) % n];
            if (k > begin && !lies_in(here, before)) {
                const auto between = corners_between(planes, here, left_along, plane_of_edge(before, corner));
                lid.insert(lid.end(), between.begin(), between.end());
            }
            if (k == begin + n) break;
            lid.push_back(corner);
            if (!lies_in(here, next)) left_along = plane_of_edge(corner, next);
        }
        missing -= twice_area(lid);
        if (is_sliver(lid, gap)) all.pop_back();
    }
    return missing.norm() <= 4 * gap * length_around(rim) ? all : std::vector<ConvexPolygon>();
}

}  // namespace ff
