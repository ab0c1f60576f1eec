#include "core/configurations/formulas/nested_cubes.hpp"

#include "core/configurations/formulas/kink.hpp"
#include "core/configurations/formulas/parameters.hpp"
#include "core/configurations/formulas/pi.hpp"
#include "core/formulas/rectangle_formulas.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff {
namespace {

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

/// What does not get from a face of a unit cube to the opposite one, for an inner cube of this edge.
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
