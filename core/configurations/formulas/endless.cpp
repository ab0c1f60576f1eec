#include "core/configurations/formulas/endless.hpp"

#include "core/configurations/formulas/parameters.hpp"
#include "core/configurations/formulas/pi.hpp"

#include <cmath>

namespace ff {

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
