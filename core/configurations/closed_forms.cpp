#include "core/configurations/closed_forms.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/support/error.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace ff {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// @param parameters  as the documentation of a configuration's formula names them
/// @throws UserError where one is not a positive, finite number
void expect_positive(std::string_view configuration,
                     std::initializer_list<std::pair<std::string_view, long double>> parameters) {
    for (const auto& [name, value] : parameters) {
        if (std::isfinite(value) && value > 0) continue;
        throw UserError("{}: {} = {:g} (a length or ratio of it has to be positive and finite). Correct it.",
                        configuration, name, value);
    }
}

/// @throws UserError "CONFIGURATION: PROBLEM" unless `holds`
void expect_valid(bool holds, std::string_view configuration, std::string_view problem) {
    if (!holds) throw UserError("{}: {}", configuration, problem);
}

using Real = long double;

Real factor(const Corners<Real>& from, const Corners<Real>& to) {
    return polygon_exchange_area<Real>(from, to).value / polygon_area(from);
}

void expect_coaxial(long double inner, long double outer, long double height) {
    expect_positive("coaxial cylinders", {{"inner radius", inner}, {"outer radius", outer}, {"height", height}});
    expect_valid(inner < outer, "coaxial cylinders", "the inner radius has to be smaller than the outer one");
}

constexpr AxisInterval one{0, 1};
constexpr AxisInterval three{0, 3};

/// The interval of places x on the first rectangle, from where a ray that ends `u` further meets an interval a fraction
/// of the way on: it moves by -fraction for every unit of u.
struct MovingInterval {
    AxisInterval at_rest;
    long double fraction = 0;
};

using Conditions = std::array<MovingInterval, 3>;

/// The length of what three moving intervals have in common.
long double common_length(const Conditions& conditions, long double u) {
    long double low = conditions[0].at_rest.low;
    long double high = conditions[0].at_rest.high;
    for (const auto& [at_rest, fraction] : conditions) {
        low = std::max(low, at_rest.low - fraction * u);
        high = std::min(high, at_rest.high - fraction * u);
    }
    return std::max(0.0L, high - low);
}

/// A place where a piecewise linear function changes its slope, and by how much.
struct Kink {
    long double place = 0;
    long double change = 0;
};

/// The kinks of common_length over u: among the places where two ends of intervals meet.
std::vector<Kink> kinks_of(const Conditions& conditions) {
    std::vector<long double> places;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        for (std::size_t j = 0; j < conditions.size(); ++j) {
            const long double speed = conditions[i].fraction - conditions[j].fraction;
            if (speed == 0) continue;
            for (const long double a : {conditions[i].at_rest.low, conditions[i].at_rest.high}) {
                for (const long double b : {conditions[j].at_rest.low, conditions[j].at_rest.high})
                    places.push_back((a - b) / speed);
            }
        }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());

    std::vector<Kink> kinks;
    long double slope = 0;  // beyond the first and the last place nothing is common
    for (std::size_t k = 0; k < places.size(); ++k) {
        long double next = 0;
        if (k + 1 < places.size()) {
            next = (common_length(conditions, places[k + 1]) - common_length(conditions, places[k])) /
                   (places[k + 1] - places[k]);
        }
        if (next != slope) kinks.push_back({places[k], next - slope});
        slope = next;
    }
    return kinks;
}

Conditions conditions_of(const AxisInterval& from, const AxisInterval& to, const AxisInterval& hole,
                         long double fraction) {
    return {MovingInterval{from, 0}, MovingInterval{to, 1}, MovingInterval{hole, fraction}};
}

/// The integral of f over 0 <= v <= height(u), low <= u <= high.
template <class Function, class Height>
long double integral(long double low, long double high, Height height, Function f) {
    using Rule = boost::math::quadrature::gauss<long double, 30>;
    return Rule::integrate(
        [&](long double u) {
            const auto [bottom, top] = height(u);
            return Rule::integrate([&](long double v) { return f(u, v); }, bottom, top);
        },
        low, high);
}

/// The part of the exchange between opposite faces of a unit cube that an inner cube with this edge blocks.
long double blocked_share(long double inner) {
    const long double margin = (1 - inner) / 2;
    const long double clipped = (1 - inner) / (1 + inner);  // larger offsets take part of the shadow off the face

    // The box around the shadow is as wide as inner (1 + |u|), and beyond `clipped` as the face's rest, 1 - |u|.
    const std::array<Kink, 5> kinks{Kink{-1, 1}, Kink{-clipped, -1 - inner}, Kink{0, 2 * inner},
                                    Kink{clipped, -1 - inner}, Kink{1, 1}};
    long double box = 0;
    for (const Kink& u : kinks) {
        for (const Kink& v : kinks)
            box += u.change * v.change * parallel_corner(std::abs(u.place), std::abs(v.place), 1.0L) / (2 * pi);
    }

    // A corner is a triangle with legs inner * u and inner * v, of which the face's edges take off these parts.
    const auto taken_off = [&](long double u) { return std::max(0.0L, (1 - margin - margin / u) / inner); };
    const auto corner = [&](long double u, long double v) {
        const long double rest = std::max(0.0L, 1 - taken_off(u) - taken_off(v));
        const long double squared_distance = 1 + u * u + v * v;
        return inner * inner * u * v / 2 * rest * rest / (pi * squared_distance * squared_distance);
    };
    using Range = std::array<long double, 2>;
    const auto square = [&](long double) { return Range{0, clipped}; };
    const auto until_nothing_is_left = [&](long double u) { return Range{clipped, margin * u / (u - margin)}; };
    const long double corners = integral(0, clipped, square, corner) + 2 * integral(clipped, 1, square, corner) +
                                integral(clipped, 1, until_nothing_is_left, corner);
    return box - 4 * 2 * corners;  // four quadrants of offsets, two corners each
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

long double exchange_area_through_aperture(const AxisInterval& x_from, const AxisInterval& y_from,
                                           const AxisInterval& x_to, const AxisInterval& y_to, long double gap,
                                           const Aperture& aperture) {
    expect_positive("aperture", {{"gap", gap}, {"fraction", aperture.fraction}});
    expect_valid(aperture.fraction < 1, "aperture", "it is not between the rectangles (its fraction is 1 or more).");
    const auto x_kinks = kinks_of(conditions_of(x_from, x_to, aperture.x, aperture.fraction));
    const auto y_kinks = kinks_of(conditions_of(y_from, y_to, aperture.y, aperture.fraction));
    long double sum = 0;
    for (const auto& [u, x_change] : x_kinks) {
        for (const auto& [v, y_change] : y_kinks)
            sum += x_change * y_change * parallel_corner(std::abs(u), std::abs(v), gap);
    }
    return std::max(0.0L, sum / (2 * pi));
}

long double squares_through_aperture_factor(long double edge) {
    const long double half = edge / 2;
    const AxisInterval hole{0.5L - half, 0.5L + half};
    return edge == 0 ? 0 : exchange_area_through_aperture(one, one, one, one, 1, {hole, hole, 0.5});
}

long double squares_blocked_factor(long double edge) {
    const long double open = parallel_exchange_area<long double>(one, one, one, one, 1);
    return std::max(0.0L, open - squares_through_aperture_factor(edge));
}

long double l_shaped_room_exchange_area(long double depth) {
    const long double gap = 1 + depth;
    return exchange_area_through_aperture(three, three, one, three, gap, {one, three, 1 / gap});
}

long double nested_cubes_opposite_factor(long double inner, long double outer) {
    expect_positive("nested cubes", {{"inner", inner}, {"outer", outer}});
    expect_valid(inner < outer, "nested cubes", "the inner cube does not fit into the outer one.");
    constexpr AxisInterval face{0, 1};
    return parallel_exchange_area<long double>(face, face, face, face, 1) - blocked_share(inner / outer);
}

long double nested_cubes_adjacent_factor(long double inner, long double outer) {
    const long double ratio = inner / outer;
    return (1 - ratio * ratio - nested_cubes_opposite_factor(inner, outer)) / 4;
}

}  // namespace ff
