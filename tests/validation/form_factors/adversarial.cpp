#include "tests/validation/form_factors/adversarial.hpp"

#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"
#include "tests/validation/form_factors/exchange_truths.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
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

/// The near surface lies in z = 0 and is seen from above.
bool holds_place(const Surface& near, const Vector3d& place) {
    if (const auto* disc = std::get_if<Disc>(&near.shape)) return place.norm() <= 0.999 * disc->outer_radius;
    const auto& p = parallelogram(near);
    const auto inside = [](double x, double length) { return x > 0.001 * length && x < 0.999 * length; };
    return inside(place.x(), p.edge_u.x()) && inside(place.y(), p.edge_v.y());
}

/// Whether no line from a plate to a polygon meets another plate.
bool is_clear_of(const Surface& surface, const ConvexPolygon& to, const Surface& blocker) {
    return Shaft(corners(surface.shape), to).is_clear_of(Plate(corners(blocker.shape)));
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

/// All of one surface is in front of the other.
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

/// Turns a scene, and puts it anywhere at any size.
void move(AdversarialScene& drawn, Draws& draws) {
    Vector3d axis(between(draws, -1, 1), between(draws, -1, 1), between(draws, 0.1, 1));
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(between(draws, 0, std::numbers::pi), axis.normalized()).toRotationMatrix();
    const double unit = draws.below(2) == 0 ? 1 : decades(draws, 1e-6, 1e6);
    Vector3d origin = Vector3d::Zero();
    if (draws.below(4) == 0) {
        for (double& coordinate : origin) coordinate = unit * decades(draws, 1, 1e6) * (draws.below(2) == 0 ? 1 : -1);
    }
    const auto place = [&](Vector3d& at) { at = origin + unit * (rotation * at); };
    const auto length = [&](Vector3d& along) { along = unit * (rotation * along); };
    double rims = 0;
    for (Surface& surface : drawn.scene.surfaces) {
        rims += std::sqrt(area(surface.shape)) * unit;
        surface.normal = rotation * surface.normal;
        if (auto* disc = std::get_if<Disc>(&surface.shape)) {
            place(disc->centre);
            disc->outer_radius *= unit;
        } else if (auto* ball = std::get_if<SphereZone>(&surface.shape)) {
            place(ball->centre);
            ball->radius *= unit;
        } else {
            auto& p = parallelogram(surface);
            place(p.corner);
            length(p.edge_u);
            length(p.edge_v);
        }
    }
    for (KnownExchange& known : drawn.known) known.area *= unit * unit;
    // Coordinates are rounded, and with them every rim.
    constexpr double extent = 4;
    drawn.error = drawn.error * unit * unit +
                  16 * std::numeric_limits<double>::epsilon() * (origin.norm() + extent * unit) * rims;
}

/// Two surfaces and what stands between them; empty where the drawn scene does not meet the requirements of its kind.
struct Obstructed {
    Surface near;
    Surface far;
    std::vector<Surface> plates;
    std::vector<std::pair<Surface, int>>
        hides;  ///< rectangles whose exchange with the far surface is hidden (1) or not (-1)
};

/// Whether a plate hides from the far surface only what would arrive at the near one.
bool is_fine(const Surface& plate, const Obstructed& drawn) {
    return is_caught(plate, drawn.far, drawn.near) && is_in_front(facing(plate, drawn.far), drawn.far) &&
           is_in_front(drawn.far, plate);
}

/// Plates such that no line from the far surface meets two of them.
void draw_plates(Draws& draws, Obstructed& drawn) {
    const std::size_t wanted = 1 + draws.below(3);
    const ConvexPolygon far_corners = corners(drawn.far.shape);
    for (int attempt = 0; attempt < 30 && drawn.plates.size() < wanted; ++attempt) {
        const Surface plate = draw_plate(draws, false);
        if (!is_fine(plate, drawn)) continue;
        const bool apart = std::all_of(drawn.plates.begin(), drawn.plates.end(), [&](const Surface& other) {
            return is_clear_of(plate, far_corners, other) && is_clear_of(other, far_corners, plate);
        });
        if (!apart) continue;
        drawn.plates.push_back(plate);
        drawn.hides.emplace_back(facing(plate, drawn.far), 1);
    }
}

void draw_sheet(Draws& draws, Obstructed& drawn) {
    const Surface sheet = draw_plate(draws, true);
    if (!is_fine(sheet, drawn)) return;
    const auto& p = parallelogram(sheet);
    const double width = decades(draws, 1e-4, 0.9);
    const double height = width * decades(draws, 0.3, 1);
    const Surface hole = rectangle(p.corner + between(draws, 0.02, 0.98 - 0.96 * width) * p.edge_u +
                                       between(draws, 0.02, 0.98 - 0.96 * height) * p.edge_v,
                                   0.96 * width * p.edge_u, 0.96 * height * p.edge_v);
    drawn.hides.emplace_back(facing(sheet, drawn.far), 1);
    drawn.hides.emplace_back(facing(hole, drawn.far), -1);
    add_sheet(p, parallelogram(hole), drawn.plates);
}

/// A sphere, where every line from the far surface through the box around it meets the near one.
void draw_ball(Draws& draws, Obstructed& drawn) {
    SphereZone ball;
    ball.radius = decades(draws, 1e-5, 0.2);
    ball.centre = {between(draws, -1, 1), between(draws, -1, 1), ball.radius * (1 + decades(draws, 1e-4, 1))};
    ball.axis = Vector3d::UnitZ();
    ball.low = -1;
    ball.high = 1;
    ball.facing = Facing::outward;
    const double r = ball.radius;
    for (const double z : {-r, r}) {
        const Surface side = rectangle(ball.centre + Vector3d(-r, -r, z), {2 * r, 0, 0}, {0, 2 * r, 0});
        if (!is_fine(side, drawn)) return;
    }
    drawn.plates.push_back(flat(ball, Vector3d::Zero(), no_face));
}

/// Parts of a rectangle, each a face from `first` on.
std::vector<Surface> parts_of(const Surface& surface, Grid grid, int first) {
    std::vector<Surface> parts;
    for (std::uint32_t i = 0; i < grid.parts(); ++i) {
        parts.push_back(patch(surface, grid, i));
        parts.back().face = first + static_cast<int>(i);
    }
    return parts;
}

std::optional<AdversarialScene> draw_obstructed(Trap trap, Draws& draws) {
    Obstructed drawn;
    drawn.near = rectangle({0, 0, 0}, {between(draws, 0.5, 1.5), 0, 0}, {0, between(draws, 0.5, 1.5), 0}, 0);
    if (trap == Trap::near_disc) drawn.near = flat(Disc{Vector3d::Zero(), 0, 1}, Vector3d::UnitZ(), 0);
    drawn.far = draw_far(draws);
    const Surface ground = rectangle({-1, -1, 0}, {3, 0, 0}, {0, 3, 0});
    if (!is_in_front(drawn.far, ground)) drawn.far.normal = -drawn.far.normal;
    if (!is_in_front(drawn.far, ground)) return std::nullopt;
    if (trap == Trap::hole) {
        draw_sheet(draws, drawn);
    } else if (trap == Trap::ball) {
        draw_ball(draws, drawn);
    } else {
        draw_plates(draws, drawn);
    }
    if (drawn.plates.empty()) return std::nullopt;
    AdversarialScene result;
    result.scene.faces = {"near"};
    result.scene.surfaces = {drawn.near};
    const Grid grid = trap == Trap::many_faces ? Grid{24, 25} : undivided;
    for (const Surface& far : parts_of(drawn.far, grid, 1)) {
        long double exchange = 0;
        if (trap == Trap::near_disc) {
            exchange = disc_exchange(drawn.near, far);
            result.error += 1e-12;
        } else {
            const auto whole = polygon_exchange(drawn.near, far);
            exchange = whole.value;
            result.error += static_cast<double>(whole.error);
        }
        for (const auto& [plate, sign] : drawn.hides) {
            const auto hidden = polygon_exchange(plate, far);
            exchange -= sign * hidden.value;
            result.error += static_cast<double>(hidden.error);
        }
        if (trap == Trap::ball) {
            exchange -= ball_exchange(std::get<SphereZone>(drawn.plates.front().shape), far);
            result.error += 1e-13;
        }
        result.known.push_back({0, static_cast<std::uint32_t>(far.face), static_cast<double>(exchange)});
        result.scene.faces.push_back(fmt::format("far {}", far.face));
        result.scene.surfaces.push_back(far);
    }
    result.scene.surfaces.insert(result.scene.surfaces.end(), drawn.plates.begin(), drawn.plates.end());
    return result;
}

/// A room with a plate near its floor that is a face above and an occluder beneath. Known exchanges are those of the
/// ceiling with all others, and of the plate with the walls: the plate is so near to the floor, and so far from the
/// walls, that no line from the ceiling passes it and meets a wall below.
AdversarialScene draw_room(Draws& draws) {
    const Vector3d size(between(draws, 1, 3), between(draws, 1, 3), between(draws, 0.5, 2));
    const Vector3d x(size.x(), 0, 0);
    const Vector3d y(0, size.y(), 0);
    const Vector3d z(0, 0, size.z());
    const double gap = decades(draws, 1e-6, 1e-2);
    const double edge = decades(draws, 1e-4, 0.4);
    const Vector3d corner(between(draws, 0.2, 0.8 * size.x() - edge), between(draws, 0.2, 0.8 * size.y() - edge), gap);
    const Surface plate = rectangle(corner, {edge, 0, 0}, {0, edge, 0}, 6);
    Surface beneath = rectangle(corner, {0, edge, 0}, {edge, 0, 0});
    AdversarialScene result;
    result.scene.closed = true;
    result.scene.faces = {"floor", "ceiling", "south", "east", "north", "west", "plate"};
    result.scene.surfaces = {rectangle({0, 0, 0}, x, y, 0),
                             rectangle(z, y, x, 1),
                             rectangle({0, 0, 0}, z, x, 2),
                             rectangle(x, z, y, 3),
                             rectangle(x + y, z, -x, 4),
                             rectangle(y, z, -y, 5),
                             plate,
                             beneath};
    const auto add = [&](std::uint32_t from, std::uint32_t to, const Surface& a, const Surface& b, double hidden) {
        const auto exchange = polygon_exchange(a, b);
        result.known.push_back({from, to, static_cast<double>(exchange.value) - hidden});
        result.error += 2 * static_cast<double>(exchange.error);
    };
    const auto& surfaces = result.scene.surfaces;
    const double hidden = static_cast<double>(polygon_exchange(surfaces[1], plate).value);
    add(0, 1, surfaces[0], surfaces[1], hidden);
    add(1, 6, surfaces[1], plate, 0);
    for (std::uint32_t wall = 2; wall < 6; ++wall) {
        add(1, wall, surfaces[1], surfaces[wall], 0);
        Surface above = surfaces[wall];  // of the plate's plane
        auto& p = parallelogram(above);
        p.corner.z() += gap;
        p.edge_u.z() -= gap;
        add(wall, 6, above, plate, 0);
    }
    return result;
}

}  // namespace

std::string_view name(Trap trap) {
    switch (trap) {
        case Trap::plates:
            return "plates before a rectangle";
        case Trap::hole:
            return "a sheet with a hole";
        case Trap::near_disc:
            return "plates before a disc";
        case Trap::ball:
            return "a sphere before a rectangle";
        case Trap::many_faces:
            return "plates before one of 601 faces";
        case Trap::room:
            break;
    }
    return "a room with a plate on its floor";
}

AdversarialScene draw_adversarial(Trap trap, Draws& draws) {
    std::optional<AdversarialScene> drawn;
    while (!drawn) drawn = trap == Trap::room ? draw_room(draws) : draw_obstructed(trap, draws);
    drawn->scene.name = drawn->scene.canonical = "adversarial";
    move(*drawn, draws);
    return std::move(*drawn);
}

}  // namespace ff::studies::form_factors
