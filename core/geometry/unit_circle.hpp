#pragma once

#include <array>

namespace ff {

struct CirclePoint {
    double cosine = 1;
    double sine = 0;
};

/// The point of the unit circle at an azimuth in turns, 0 <= turns <= 1, within 3e-16 and the same to the bit on every
/// CPU, which the C library does not promise.
CirclePoint unit_circle(double turns);

/// atan(x) = x + x^3 P(x^2) for |x| <= tan(pi/8), P from its highest power on: interpolated at Chebyshev nodes,
/// relative error 7e-18 before rounding.
inline constexpr std::array<double, 11> arc_tangent_series{-0.01917688711906226,
                                                           0.03923165829558719,
                                                           -0.0508544973794026,
                                                           0.0585814891280221,
                                                           -0.06664511447381948,
                                                           0.07692183190826087,
                                                           -0.09090904578123903,
                                                           0.11111111015256361,
                                                           -0.14285714284666542,
                                                           0.1999999999999552,
                                                           -1.0 / 3};

/// The angle in radians, 0 to pi, with this sine and cosine up to a common factor; 0 where both are 0. The same to the
/// bit on every CPU. @pre sine >= 0
double angle_of(double sine, double cosine);

}  // namespace ff
