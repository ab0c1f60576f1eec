#include "studies/form_factors/adversarial.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/visible_polygon.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using stats::Draws;

double between(Draws& draws, double low, double high) {
    return low + (high - low) * draws.uniform();
}

double decades(Draws& draws, double low, double high) {
    return std::exp(between(draws, std::log(low), std::log(high)));
}

Surface flat(const Shape& shape, const Vector3d& normal, int face) {
    return {shape, normal, face};
}

Surface rectangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v, int face = no_face) {
    return flat(Parallelogram{corner, u, v}, u.cross(v).normalized(), face);
}

BoundedValue<long double> polygon_exchange(const Surface& a, const Surface& b) {
    const auto of = [](const Surface& surface) {
        Corners<long double> result;
        for (const Vector3d& corner : corners(surface.shape)) result.push_back(corner.cast<long double>());
        const auto across = (result[1] - result[0]).cross(result[2] - result[1]).eval();
        if (across.dot(surface.normal.cast<long double>()) < 0) std::reverse(result.begin(), result.end());
        return result;
    };
    return polygon_exchange_area<long double>(of(a), of(b));
}

/// The near surface lies in z = 0 and is seen from above.
bool holds_place(const Surface& near, const Vector3d& place) {
    if (const auto* disc = std::get_if<Disc>(&near.shape)) return place.norm() <= 0.999 * disc->outer_radius;
    const auto& p = parallelogram(near);
    const auto inside = [](double x, double length) { return x > 0.001 * length && x < 0.999 * length; };
    return inside(place.x(), p.edge_u.x()) && inside(place.y(), p.edge_v.y());
}

/// Whether no line from a plate to a polygon meets another plate.
bool is_clear_of(const Surface& plate, const ConvexPolygon& to, const Surface& other) {
    return Shaft(corners(plate.shape), to).crossed_by(corners(other.shape)) == Shaft::Crossing::none;
}

/// Whether every line from the far surface through an obstacle meets the near one.
bool is_caught(const Surface& obstacle, const Surface& far, const Surface& near) {
    for (const Vector3d& through : corners(obstacle.shape)) {
        if (!(through.z() > 0)) return false;
        for (const Vector3d& end : corners(far.shape)) {
            if (!(end.z() > 1.01 * through.z())) return false;
            if (!holds_place(near, end + (through - end) * (end.z() / (end.z() - through.z())))) return false;
        }
    }
    return true;
}

/// Towards the far surface, so that the obstacle's own exchange is what it hides.
Surface facing(Surface obstacle, const Surface& far) {
    const auto& p = parallelogram(obstacle);
    const Vector3d middle = p.corner + (p.edge_u + p.edge_v) / 2;
    Vector3d towards = Vector3d::Zero();
    for (const Vector3d& corner : corners(far.shape)) towards += corner - middle;
    if (obstacle.normal.dot(towards) < 0) obstacle.normal = -obstacle.normal;
    return obstacle;
}

/// All of one is in front of the other: it has one side to it.
bool is_in_front(const Surface& of, const Surface& other) {
    for (const Vector3d& corner : corners(other.shape)) {
        if (!(of.normal.dot(corner - corners(of.shape).front()) > 0)) return false;
    }
    return true;
}

/// A rectangle of any size near the surface in z = 0.
Surface draw_plate(Draws& draws, bool level) {
    const double size = decades(draws, 1e-5, 0.5);
    const double gap = decades(draws, 1e-5, 1) * std::min(0.3, size * 10);
    const double azimuth = between(draws, 0, 2 * std::numbers::pi);
    const double tilt = level || draws.below(2) == 0 ? 0 : between(draws, 0, 1.2);
    const Vector3d u(std::cos(azimuth), std::sin(azimuth), 0);
    const Vector3d v =
        Vector3d(-std::sin(azimuth), std::cos(azimuth), 0) * std::cos(tilt) + Vector3d(0, 0, std::sin(tilt));
    const Vector3d corner(between(draws, -1, 1), between(draws, -1, 1), gap);
    return rectangle(corner, size * u, size * decades(draws, 0.05, 1) * v);
}

Surface draw_far(Draws& draws) {
    const double height = decades(draws, 0.3, 3);
    const double size = decades(draws, 0.1, 2);
    const double tilt = between(draws, -0.4, 0.4);
    const Vector3d u(0, size * std::cos(tilt), size * std::sin(tilt));
    const Vector3d v(size * between(draws, 0.3, 1.5), 0, 0);
    const Vector3d corner(between(draws, -1, 1), between(draws, -1, 1), height + size / 2);
    return rectangle(corner, u, v, 1);
}

/// Four pieces of a rectangle around a rectangular hole.
void add_sheet(const Parallelogram& sheet, const Parallelogram& hole, std::vector<Surface>& pieces) {
    const Vector3d u = sheet.edge_u.normalized();
    const Vector3d v = sheet.edge_v.normalized();
    const Vector3d& across_u = hole.edge_u;
    const double before_u = (hole.corner - sheet.corner).dot(u);
    const double before_v = (hole.corner - sheet.corner).dot(v);
    pieces.push_back(rectangle(sheet.corner, before_u * u, sheet.edge_v));
    const Vector3d right = sheet.corner + before_u * u + across_u;
    pieces.push_back(rectangle(right, sheet.edge_u - before_u * u - across_u, sheet.edge_v));
    const Vector3d middle = sheet.corner + before_u * u;
    pieces.push_back(rectangle(middle, across_u, before_v * v));
    const Vector3d above = middle + before_v * v + hole.edge_v;
    pieces.push_back(rectangle(above, across_u, sheet.edge_v - before_v * v - hole.edge_v));
}

/// Of a disc and a polygon above its plane, with nothing in between: a smooth integrand, by rules that converge faster
/// than any power of their size.
double disc_exchange(const Surface& disc, const Surface& far) {
    const VisiblePolygon target(far, {});
    const double radius = std::get<Disc>(disc.shape).outer_radius;
    constexpr int rings = 48;
    constexpr int spokes = 192;
    double sum = 0;
    double weights = 0;
    for (int i = -3 * rings; i <= 3 * rings; ++i) {
        const double x = 3.2 * i / (3.0 * rings);
        const double inner = std::numbers::pi / 2 * std::sinh(x);
        const double r2 = 0.5 * (1 + std::tanh(inner));
        const double weight = std::cosh(x) / (std::cosh(inner) * std::cosh(inner));
        double ring = 0;
        for (int k = 0; k < spokes; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / spokes;
            const Vector3d place = radius * std::sqrt(r2) * Vector3d(std::cos(angle), std::sin(angle), 0);
            ring += target.from(place, Vector3d::UnitZ()).whole;
        }
        sum += weight * ring / spokes;
        weights += weight;
    }
    return std::numbers::pi * radius * radius * sum / weights;
}

void turn(Scene& scene, Draws& draws) {
    Vector3d axis(between(draws, -1, 1), between(draws, -1, 1), between(draws, 0.1, 1));
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(between(draws, 0, std::numbers::pi), axis.normalized()).toRotationMatrix();
    for (Surface& surface : scene.surfaces) {
        surface.normal = rotation * surface.normal;
        if (auto* disc = std::get_if<Disc>(&surface.shape)) {
            disc->centre = rotation * disc->centre;
        } else {
            auto& p = parallelogram(surface);
            p = {rotation * p.corner, rotation * p.edge_u, rotation * p.edge_v};
        }
    }
}

}  // namespace

std::string_view name(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::plates:
            return "plates before a rectangle";
        case Obstacle::hole:
            return "a sheet with a hole";
        case Obstacle::near_disc:
            break;
    }
    return "plates before a disc";
}

AdversarialScene draw_adversarial(Obstacle obstacle, Draws& draws) {
    AdversarialScene result;
    for (;;) {
        Surface near = rectangle({0, 0, 0}, {between(draws, 0.5, 1.5), 0, 0}, {0, between(draws, 0.5, 1.5), 0}, 0);
        if (obstacle == Obstacle::near_disc) near = flat(Disc{Vector3d::Zero(), 0, 1}, Vector3d::UnitZ(), 0);
        Surface far = draw_far(draws);
        if (!is_in_front(far, rectangle({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}))) far.normal = -far.normal;
        if (!is_in_front(far, rectangle({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}))) continue;
        std::vector<Surface> in_between;
        long double hidden = 0;
        long double error = 0;
        const auto add = [&](const Surface& plate, int sign) {
            const auto exchange = polygon_exchange(facing(plate, far), far);
            hidden += sign * exchange.value;
            error += exchange.error;
        };
        const auto is_fine = [&](const Surface& plate) {
            return is_caught(plate, far, near) && is_in_front(facing(plate, far), far) && is_in_front(far, plate);
        };
        if (obstacle == Obstacle::hole) {
            const Surface sheet = draw_plate(draws, true);
            const auto& p = parallelogram(sheet);
            const double width = decades(draws, 1e-4, 0.9);
            const double height = width * decades(draws, 0.3, 1);
            const Surface hole = rectangle(p.corner + between(draws, 0.02, 0.98 - 0.96 * width) * p.edge_u +
                                               between(draws, 0.02, 0.98 - 0.96 * height) * p.edge_v,
                                           0.96 * width * p.edge_u, 0.96 * height * p.edge_v);
            if (!is_fine(sheet)) continue;
            add(sheet, 1);
            add(hole, -1);
            add_sheet(p, parallelogram(hole), in_between);
        } else {
            const std::size_t wanted = 1 + draws.below(3);
            for (int attempt = 0; attempt < 30 && in_between.size() < wanted; ++attempt) {
                const Surface plate = draw_plate(draws, false);
                if (!is_fine(plate)) continue;
                const ConvexPolygon far_corners = corners(far.shape);
                bool apart = true;  // no line from the far surface meets two of them
                for (const Surface& other : in_between) {
                    apart = apart && is_clear_of(plate, far_corners, other) && is_clear_of(other, far_corners, plate);
                }
                if (!apart) continue;
                add(plate, 1);
                in_between.push_back(plate);
            }
            if (in_between.empty()) continue;
        }
        long double whole = 0;
        if (obstacle == Obstacle::near_disc) {
            whole = disc_exchange(near, far);
            error += 1e-12L;
        } else {
            const auto exchange = polygon_exchange(near, far);
            whole = exchange.value;
            error += exchange.error;
        }
        result.exchange = static_cast<double>(whole - hidden);
        result.exchange_error = static_cast<double>(error);
        result.scene.name = result.scene.canonical = "adversarial";
        result.scene.faces = {"near", "far"};
        result.scene.surfaces = {near, far};
        result.scene.surfaces.insert(result.scene.surfaces.end(), in_between.begin(), in_between.end());
        turn(result.scene, draws);
        return result;
    }
}

}  // namespace ff::studies
