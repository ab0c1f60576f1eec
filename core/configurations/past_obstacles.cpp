#include "core/configurations/past_obstacles.hpp"

#include "core/configurations/parameters.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff {
namespace {

constexpr AxisInterval one{0, 1};
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

Conditions conditions_of(const AxisInterval& from, const AxisInterval& to, const AxisInterval& hole,
                         long double fraction) {
    return {MovingInterval{from, 0}, MovingInterval{to, 1}, MovingInterval{hole, fraction}};
}

/// The integral of f over 0 <= v <= height(u), low <= u <= high.
template <class Function, class Height>
long double integral(long double low, long double high, Height height, Function f) {
    using Rule = boost::math::quadrature::gauss<long double, 30>;
    return Rule::integrate(
        [&](long double u) {
            const auto [bottom, top] = height(u);
            return Rule::integrate([&](long double v) { return f(u, v); }, bottom, top);
        },
        low, high);
}

/// The part of the exchange between opposite faces of a unit cube that an inner cube with this edge blocks.
long double blocked_share(long double inner) {
    const long double margin = (1 - inner) / 2;
    const long double clipped = (1 - inner) / (1 + inner);  // larger offsets take part of the shadow off the face

    // The box around the shadow is as wide as inner (1 + |u|), and beyond `clipped` as the face's rest, 1 - |u|.
    const std::array<Kink, 5> kinks{Kink{-1, 1}, Kink{-clipped, -1 - inner}, Kink{0, 2 * inner},
                                    Kink{clipped, -1 - inner}, Kink{1, 1}};
    long double box = 0;
    for (const Kink& u : kinks) {
        for (const Kink& v : kinks)
            box += u.change * v.change * parallel_corner(std::abs(u.place), std::abs(v.place), 1.0L) / (2 * pi);
    }

    // A corner is a triangle with legs inner * u and inner * v, of which the face's edges take off these parts.
    const auto taken_off = [&](long double u) { return std::max(0.0L, (1 - margin - margin / u) / inner); };
    const auto corner = [&](long double u, long double v) {
        const long double rest = std::max(0.0L, 1 - taken_off(u) - taken_off(v));
        const long double squared_distance = 1 + u * u + v * v;
        return inner * inner * u * v / 2 * rest * rest / (pi * squared_distance * squared_distance);
    };
    using Range = std::array<long double, 2>;
    const auto square = [&](long double) { return Range{0, clipped}; };
    const auto until_nothing_is_left = [&](long double u) { return Range{clipped, margin * u / (u - margin)}; };
    const long double corners = integral(0, clipped, square, corner) + 2 * integral(clipped, 1, square, corner) +
                                integral(clipped, 1, until_nothing_is_left, corner);
    return box - 4 * 2 * corners;  // four quadrants of offsets, two corners each
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
    return edge == 0 ? 0 : exchange_area_through_aperture(one, one, one, one, 1, {hole, hole, 0.5});
}

long double squares_blocked_factor(long double edge) {
    const long double open = parallel_exchange_area<long double>(one, one, one, one, 1);
    return std::max(0.0L, open - squares_through_aperture_factor(edge));
}

long double l_shaped_room_exchange_area(long double depth) {
    const long double gap = 1 + depth;
    return exchange_area_through_aperture(three, three, one, three, gap, {one, three, 1 / gap});
}

long double nested_cubes_opposite_factor(long double inner, long double outer) {
    expect_positive("nested cubes", {{"inner", inner}, {"outer", outer}});
    expect_valid(inner < outer, "nested cubes", "the inner cube does not fit into the outer one.");
    constexpr AxisInterval face{0, 1};
    return parallel_exchange_area<long double>(face, face, face, face, 1) - blocked_share(inner / outer);
}

long double nested_cubes_adjacent_factor(long double inner, long double outer) {
    const long double ratio = inner / outer;
    return (1 - ratio * ratio - nested_cubes_opposite_factor(inner, outer)) / 4;
}

}  // namespace ff
