#include "core/configurations/formulas/aperture.hpp"

#include "core/configurations/formulas/kink.hpp"
#include "core/configurations/formulas/parameters.hpp"
#include "core/configurations/formulas/pi.hpp"
#include "core/formulas/rectangle_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff {
namespace {

constexpr AxisInterval unit{0, 1};
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

}  // namespace

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
    return edge == 0 ? 0 : exchange_area_through_aperture(unit, unit, unit, unit, 1, {hole, hole, 0.5});
}

long double squares_blocked_factor(long double edge) {
    const long double open = parallel_exchange_area<long double>(unit, unit, unit, unit, 1);
    return std::max(0.0L, open - squares_through_aperture_factor(edge));
}

long double l_shaped_room_exchange_area(long double depth) {
    const long double gap = 1 + depth;
    return exchange_area_through_aperture(three, three, unit, three, gap, {unit, three, 1 / gap});
}

}  // namespace ff
