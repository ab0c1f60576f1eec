#include "core/formulas/far_exchange.hpp"

#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr int nodes = 8;
using Rule = boost::math::quadrature::gauss<double, nodes>;

/// Least distance in sums of half edges.
constexpr double least_distance = 32;

/// A place of a polygon relative to its middle, and the area that it stands for.
struct Node {
    Vector3d offset;
    double area = 0;
};

/// A polygon as corner + s u + s^k t v with 0 <= s, t <= 1: a parallelogram with k = 0, a triangle with k = 1.
struct SpannedPolygon {
    Vector3d corner, u, v;
    bool is_triangle = false;

    /// Largest displacement of a place while one coordinate goes from its middle to an end.
    [[nodiscard]] double reach_s() const { return std::max(u.norm(), (u + v).norm()) / 2; }
    [[nodiscard]] double reach_t() const { return v.norm() / 2; }
    [[nodiscard]] Vector3d middle() const {
        return is_triangle ? Vector3d(corner + u / 2 + v / 4) : Vector3d(corner + u / 2 + v / 2);
    }
};

std::optional<SpannedPolygon> polygon_of(const Surface& surface) {
    if (const auto* p = std::get_if<Parallelogram>(&surface.shape))
        return SpannedPolygon{p->corner, p->edge_u, p->edge_v, false};
    if (const auto* p = std::get_if<Triangle>(&surface.shape))
        return SpannedPolygon{p->a, p->b - p->a, p->c - p->b, true};
    return std::nullopt;
}

/// Nodes and weights of the rule on [0, 1].
std::array<std::array<double, 2>, nodes> rule() {
    std::array<std::array<double, 2>, nodes> result{};
    for (int k = 0; k < nodes / 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double x = Rule::abscissa()[at];
        const double w = Rule::weights()[at];
        result.at(2 * at) = {(1 - x) / 2, w / 2};
        result.at(2 * at + 1) = {(1 + x) / 2, w / 2};
    }
    return result;
}

std::vector<Node> nodes_of(const SpannedPolygon& polygon) {
    std::vector<Node> result;
    const double whole = polygon.u.cross(polygon.v).norm();
    const Vector3d start = polygon.corner - polygon.middle();
    for (const auto& [s, weight_s] : rule()) {
        for (const auto& [t, weight_t] : rule()) {
            const double shrink = polygon.is_triangle ? s : 1;
            result.push_back({start + s * polygon.u + shrink * t * polygon.v, weight_s * weight_t * shrink * whole});
        }
    }
    return result;
}

bool is_in_front(const Surface& surface, const Surface& of) {
    const std::vector<Vector3d> around = corners(surface.shape);
    const Vector3d place = corners(of.shape).front();
    return std::all_of(around.begin(), around.end(),
                       [&](const Vector3d& corner) { return of.normal.dot(corner - place) > 0; });
}

}  // namespace

std::optional<BoundedValue<double>> far_exchange_area(const Surface& from, const Surface& to) {
    const auto a = polygon_of(from);
    const auto b = polygon_of(to);
    if (!a || !b) return std::nullopt;
    const Vector3d between = b->middle() - a->middle();
    const double distance = between.norm();
    const std::array reaches{a->reach_s(), a->reach_t(), b->reach_s(), b->reach_t()};
    double sum_of_reaches = 0;
    for (const double reach : reaches) sum_of_reaches += reach;
    if (!(distance >= least_distance * sum_of_reaches) || !is_in_front(from, to) || !is_in_front(to, from))
        return std::nullopt;

    BoundedValue<double> result;
    double sizes = 0;  // sum of the terms without their cosines
    const std::vector<Node> of_b = nodes_of(*b);
    for (const Node& x : nodes_of(*a)) {
        for (const Node& y : of_b) {
            // Heights to within rounding of the reach, not of the distance.
            const Vector3d way = between + (y.offset - x.offset);
            const double squared = way.squaredNorm();
            const double weight = x.area * y.area / (std::numbers::pi * squared * squared);
            result.value += weight * from.normal.dot(way) * -to.normal.dot(way);
            sizes += weight * squared;
        }
    }
    // A place moves by at most (1/32 + 1/4) of the distance d while a coordinate is complex with |z| <= d / (4 reach):
    // then |r . r| >= (1 - 9/16 - 81/1024) d^2 and the cosines' product is at most (41/32)^2 d^2.
    constexpr double most = 41.0 / 32 * 41 / 32 / ((1 - 9.0 / 16 - 81.0 / 1024) * (1 - 9.0 / 16 - 81.0 / 1024));
    const double scale = area(from.shape) * area(to.shape) / (std::numbers::pi * distance * distance);
    for (const double reach : reaches) {
        const double ellipse = distance / (4 * reach);
        const double jacobian = 1 + ellipse;  // bound of twice s, the Jacobian of a triangle
        result.error +=
            64.0 / 15 * most * jacobian * std::pow(ellipse, -2.0 * nodes) / (1 - 1 / (ellipse * ellipse)) * scale;
    }
    result.error += 64 * std::numeric_limits<double>::epsilon() * sizes;
    return result;
}

}  // namespace ff
