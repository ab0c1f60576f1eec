#include "core/configurations/aperture.hpp"

#include "core/configurations/parameters.hpp"
#include "core/formulas/rectangle_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// The interval of places x on the first rectangle, from where a ray that ends `u` further meets an interval a fraction
/// of the way on: it moves by -fraction for every unit of u.
struct MovingInterval {
    Interval at_rest;
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

/// A place where a piecewise linear function changes its slope, and by how much.
struct Kink {
    long double place = 0;
    long double change = 0;
};

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

Conditions conditions_of(const Interval& from, const Interval& to, const Interval& hole, long double fraction) {
    return {MovingInterval{from, 0}, MovingInterval{to, 1}, MovingInterval{hole, fraction}};
}

}  // namespace

long double exchange_area_through_aperture(const Interval& x_from, const Interval& y_from, const Interval& x_to,
                                           const Interval& y_to, long double gap, const Aperture& aperture) {
    expect_positive("aperture", {{"gap", gap}, {"fraction", aperture.fraction}});
    expect_valid(aperture.fraction < 1, "aperture", "it is not between the rectangles (its fraction is 1 or more).");
    const auto x_kinks = kinks_of(conditions_of(x_from, x_to, aperture.x, aperture.fraction));
    const auto y_kinks = kinks_of(conditions_of(y_from, y_to, aperture.y, aperture.fraction));
    long double sum = 0;
    for (const auto& [u, x_change] : x_kinks) {
        for (const auto& [v, y_change] : y_kinks)
            sum += x_change * y_change * parallel_corner(std::abs(u), std::abs(v), gap);
    }
    return std::max(0.0L, sum / (2 * std::numbers::pi_v<long double>));
}

}  // namespace ff
