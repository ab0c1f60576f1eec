#include "core/geometry/unit_circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

/// Taylor's series to x^17 and x^16: what follows is below 1e-18 at |x| = pi / 4.
constexpr int terms = 8;

}  // namespace

CirclePoint unit_circle(double turns) {
    const double quarters = std::nearbyint(4 * turns);
    const double x = (turns - quarters / 4) * (2 * std::numbers::pi);
    const double x2 = x * x;
    double sine = 1;
    double cosine = 1;
    for (int k = terms; k > 0; --k) {
        sine = 1 - sine * x2 / (2 * k * (2 * k + 1));
        cosine = 1 - cosine * x2 / (2 * k * (2 * k - 1));
    }
    sine *= x;
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

double angle_of(double sine, double cosine) {
    constexpr double tan_pi_8 = std::numbers::sqrt2 - 1;
    const double low = std::min(sine, std::abs(cosine));
    const double high = std::max(sine, std::abs(cosine));
    if (!(high > 0)) return 0;
    const bool middle = low > high * tan_pi_8;  // beyond pi/8, measure from pi/4
    const double x = middle ? (low - high) / (low + high) : low / high;
    double p = 0;
    for (const double c : arc_tangent_series) p = p * (x * x) + c;
    double angle = x + x * (x * x) * p;
    if (middle) angle += std::numbers::pi / 4;
    if (sine > std::abs(cosine)) angle = std::numbers::pi / 2 - angle;
    return cosine < 0 ? std::numbers::pi - angle : angle;
}

}  // namespace ff
