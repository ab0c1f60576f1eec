#include "core/configurations/closed_forms.hpp"

#include "core/configurations/parameters.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/convex_polygon.hpp"

#include <cmath>

namespace ff {
namespace {

using Real = long double;

Real factor(const Corners<Real>& from, const Corners<Real>& to) {
    return polygon_exchange_area<Real>(from, to).value / polygon_area(from);
}

void expect_coaxial(long double inner, long double outer, long double height) {
    expect_positive("coaxial cylinders", {{"inner radius", inner}, {"outer radius", outer}, {"height", height}});
    expect_valid(inner < outer, "coaxial cylinders", "the inner radius has to be smaller than the outer one");
}

}  // namespace

long double rectangles_at_angle_factor(long double edge, long double from, long double to, long double angle) {
    expect_positive("rectangles at an angle", {{"edge", edge}, {"from", from}, {"to", to}, {"angle", angle}});
    expect_valid(angle < pi, "rectangles at an angle", "the angle is not below pi radians.");
    const Real y = to * std::cos(angle);
    const Real z = to * std::sin(angle);
    return factor({{0, 0, 0}, {edge, 0, 0}, {edge, from, 0}, {0, from, 0}},
                  {{0, 0, 0}, {0, y, z}, {edge, y, z}, {edge, 0, 0}});
}

long double parallel_right_triangles_factor() {
    return factor({{0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
}

long double tetrahedron_factor() {
    return factor({{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}}, {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}});
}

long double element_to_rectangle_factor(long double a, long double b, long double distance) {
    expect_positive("element to rectangle", {{"a", a}, {"b", b}, {"distance", distance}});
    const long double a_slant = std::hypot(a, distance);
    const long double b_slant = std::hypot(b, distance);
    return (a / a_slant * std::atan(b / a_slant) + b / b_slant * std::atan(a / b_slant)) / (2 * pi);
}

long double coaxial_discs_factor(long double r1, long double r2, long double distance) {
    expect_positive("coaxial discs", {{"r1", r1}, {"r2", r2}, {"distance", distance}});
    // The catalogue's (S - sqrt(S^2 - 4 R^2)) / 2 with R = r2 / r1 and S = 1 + R^2 + (h / r1)^2, without its
    // differences of nearly equal numbers.
    const long double ratio = r2 / r1;
    const long double height = distance / r1;
    const long double sum = 1 + ratio * ratio + height * height;
    const long double least = (1 - ratio) * (1 - ratio) + height * height;  // S - 2 R
    return 2 * ratio * ratio / (sum + std::sqrt(least * (sum + 2 * ratio)));
}

long double element_to_disc_factor(long double radius, long double distance) {
    expect_positive("element to disc", {{"radius", radius}, {"distance", distance}});
    const long double sine = radius / std::hypot(radius, distance);
    return sine * sine;
}

long double blocked_coaxial_discs_factor(long double r1, long double r2, long double distance, DiscBlocker blocker) {
    expect_positive("blocked coaxial discs", {{"r1", r1},
                                              {"r2", r2},
                                              {"distance", distance},
                                              {"blocker radius", blocker.radius},
                                              {"blocker distance", blocker.distance}});
    expect_valid(blocker.distance < distance, "blocked coaxial discs",
                 "the blocker is not between the discs. Its distance from the first has to be smaller than theirs.");
    // The ray that goes farthest out past the blocker comes from the opposite rim of the first disc.
    const long double shadow =
        blocker.radius + (blocker.radius + r1) * (distance - blocker.distance) / blocker.distance;
    expect_valid(shadow <= r2, "blocked coaxial discs",
                 "the blocker's shadow is wider than the second disc (the formula holds only where all of it falls on "
                 "it). Take a smaller blocker or a larger disc.");
    return coaxial_discs_factor(r1, r2, distance) - coaxial_discs_factor(r1, blocker.radius, blocker.distance);
}

long double sphere_to_disc_factor(long double disc_radius, long double distance) {
    expect_positive("sphere to disc", {{"disc radius", disc_radius}, {"distance", distance}});
    const long double slant = std::hypot(disc_radius, distance);
    const long double sine = disc_radius / slant;
    return sine * sine / (1 + distance / slant) / 2;  // (1 - cosine) / 2
}

long double sphere_cap_factor(long double sphere_radius, long double cap_height) {
    expect_positive("sphere cap", {{"sphere radius", sphere_radius}, {"cap height", cap_height}});
    expect_valid(cap_height <= 2 * sphere_radius, "sphere cap",
                 "the cap is higher than the sphere. Its height is at most twice the radius.");
    return cap_height / (2 * sphere_radius);
}

long double outer_sphere_to_itself_factor(long double inner_radius, long double outer_radius) {
    expect_positive("concentric spheres", {{"inner radius", inner_radius}, {"outer radius", outer_radius}});
    expect_valid(inner_radius < outer_radius, "concentric spheres",
                 "the inner sphere does not fit into the outer one.");
    return (outer_radius - inner_radius) * (outer_radius + inner_radius) / (outer_radius * outer_radius);
}

long double cylinder_wall_to_itself_factor(long double radius, long double height) {
    expect_positive("cylinder wall", {{"radius", radius}, {"height", height}});
    const long double ratio = height / (2 * radius);
    return 2 * ratio / (1 + ratio + std::hypot(1.0L, ratio));  // without the difference of nearly equal numbers
}

long double cylinder_base_to_wall_factor(long double radius, long double height) {
    expect_positive("cylinder base", {{"radius", radius}, {"height", height}});
    const long double ratio = height / (2 * radius);
    return 2 * ratio / (ratio + std::hypot(1.0L, ratio));
}

long double cone_wall_to_itself_factor(long double radius, long double height) {
    expect_positive("cone wall", {{"radius", radius}, {"height", height}});
    const long double slant = std::hypot(radius, height);
    return height / slant * (height / (slant + radius));
}

long double outer_cylinder_to_inner_factor(long double inner, long double outer, long double height) {
    expect_coaxial(inner, outer, height);
    const long double r = outer / inner;
    const long double h = height / inner;
    const long double a = h * h + r * r - 1;
    const long double b = h * h - r * r + 1;
    const long double ends =
        std::sqrt((a + 2) * (a + 2) - 4 * r * r) * std::acos(b / (r * a)) + b * std::asin(1 / r) - pi * a / 2;
    return (1 - (std::acos(b / a) - ends / (2 * h)) / pi) / r;
}

long double outer_cylinder_to_itself_factor(long double inner, long double outer, long double height) {
    expect_coaxial(inner, outer, height);
    const long double r2 = (outer / inner) * (outer / inner);
    const long double r = outer / inner;
    const long double h = height / inner;
    const long double diagonal = std::sqrt(4 * r2 + h * h) / h;
    const long double far = 4 * (r2 - 1);
    const long double ends = diagonal * std::asin((far + h * h / r2 * (r2 - 2)) / (h * h + far)) -
                             std::asin((r2 - 2) / r2) + pi / 2 * (diagonal - 1);
    return 1 - 1 / r + 2 / (pi * r) * std::atan(2 * std::sqrt(r2 - 1) / h) - h / (2 * pi * r) * ends;
}

long double wedge_factor(long double angle) {
    expect_valid(angle >= 0 && angle <= pi, "wedge", "the angle is not between 0 and pi radians.");
    const long double sine = std::sin((pi - angle) / 4);  // 1 - cos(x) = 2 sin(x / 2)^2
    return 2 * sine * sine;
}

long double plane_to_tubes_factor(long double cover) {
    expect_valid(cover >= 0 && cover <= 1, "plane to tubes",
                 "the diameter over the distance of the axes is not between 0 and 1.");
    const long double sine = std::sqrt((1 - cover) * (1 + cover));
    return cover * cover / (1 + sine) + cover * std::acos(cover);  // the first term is 1 - sine
}

}  // namespace ff
