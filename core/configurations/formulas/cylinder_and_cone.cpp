#include "core/configurations/formulas/cylinder_and_cone.hpp"

#include "core/configurations/formulas/parameters.hpp"
#include "core/configurations/formulas/pi.hpp"

#include <cmath>

namespace ff {
namespace {

void expect_coaxial(long double inner, long double outer, long double height) {
    expect_positive("coaxial cylinders", {{"inner radius", inner}, {"outer radius", outer}, {"height", height}});
    expect_valid(inner < outer, "coaxial cylinders", "the inner radius has to be smaller than the outer one");
}

}  // namespace

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

}  // namespace ff
