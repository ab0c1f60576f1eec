#include "core/configurations/formulas/spheres.hpp"

#include "core/configurations/formulas/parameters.hpp"

#include <cmath>

namespace ff {

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

}  // namespace ff
