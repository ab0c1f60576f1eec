#include "core/geometry/unit_circle.hpp"

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

}  // namespace ff
