#include "core/configurations/cylinder_and_cone.hpp"

#include "core/configurations/parameters.hpp"

#include <cmath>

namespace ff {

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

}  // namespace ff
