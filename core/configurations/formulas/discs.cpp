#include "core/configurations/formulas/discs.hpp"

#include "core/configurations/formulas/parameters.hpp"

#include <cmath>

namespace ff {

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

}  // namespace ff
