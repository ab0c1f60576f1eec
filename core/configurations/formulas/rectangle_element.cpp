#include "core/configurations/formulas/rectangle_element.hpp"

#include "core/configurations/formulas/parameters.hpp"

#include <cmath>
#include <numbers>

namespace ff {

long double element_to_rectangle_factor(long double a, long double b, long double distance) {
    expect_positive("element to rectangle", {{"a", a}, {"b", b}, {"distance", distance}});
    const long double a_slant = std::hypot(a, distance);
    const long double b_slant = std::hypot(b, distance);
    return (a / a_slant * std::atan(b / a_slant) + b / b_slant * std::atan(a / b_slant)) /
           (2 * std::numbers::pi_v<long double>);
}

}  // namespace ff
