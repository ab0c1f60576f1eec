#include "tests/validation/form_factors/tiled_walls.hpp"

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ff::studies::form_factors {
namespace {

struct Range {
    double low = 0;
    double high = 0;
};
using Rectangle = std::array<Range, 2>;

Surface level_surface(const Rectangle& where, double z, double up, std::size_t face) {
    const auto& [x, y] = where;
    return {Parallelogram{{x.low, y.low, z}, {x.high - x.low, 0, 0}, {0, y.high - y.low, 0}},
            {0, 0, up},
            static_cast<int>(face)};
}

/// Form factor from an area element at the origin to a parallel rectangle at a height. @see [howell] B-3
double factor_from_origin(const Rectangle& seen, double height) {
    const auto corner = [height](double x, double y) {
        const double a = std::hypot(x, height);
        const double b = std::hypot(y, height);
        return x / a * std::atan(y / a) + y / b * std::atan(x / b);
    };
    const auto& [x, y] = seen;
    return (corner(x.high, y.high) - corner(x.low, y.high) - corner(x.high, y.low) + corner(x.low, y.low)) /
           (2 * std::numbers::pi);
}

/// Intervals along one axis: places on a tile, what is opposite, and the plate's shadow there.
struct Axis {
    Range tile, opposite, plate;
    double magnification = 1;  ///< magnification of the shadow

    [[nodiscard]] double shadow(double edge, double place) const { return place + (edge - place) * magnification; }
    /// The opposite tile or its part in the shadow, relative to a place.
    [[nodiscard]] Range seen(double place, bool shadowed) const {
        if (!shadowed) return {opposite.low - place, opposite.high - place};
        const double low = std::clamp(shadow(plate.low, place), opposite.low, opposite.high);
        const double high = std::clamp(shadow(plate.high, place), opposite.low, opposite.high);
        return {low - place, high - place};
    }
    /// Ends of the pieces of a tile within which the integrand has no bend.
    [[nodiscard]] std::vector<double> pieces() const {
        std::vector<double> ends{tile.low, tile.high};
        for (const double edge : {plate.low, plate.high}) {
            for (const double line : {opposite.low, opposite.high}) {
                const double place = (line - edge * magnification) / (1 - magnification);
                if (place > tile.low && place < tile.high) ends.push_back(place);
            }
        }
        std::sort(ends.begin(), ends.end());
        return ends;
    }
};

/// @param axes  x and y
double exchange_past_plate(const std::array<Axis, 2>& axes, double height) {
    using Rule = boost::math::quadrature::gauss<double, 15>;
    const auto over = [](const std::vector<double>& ends, const auto& f) {
        double sum = 0;
        for (std::size_t k = 1; k < ends.size(); ++k) {
            if (ends[k] > ends[k - 1]) sum += Rule::integrate(f, ends[k - 1], ends[k]);
        }
        return sum;
    };
    const Axis& x = axes[0];
    const Axis& y = axes[1];
    const std::vector<double> pieces_of_y = y.pieces();
    return over(x.pieces(), [&](double px) {
        return over(pieces_of_y, [&](double py) {
            return factor_from_origin({x.seen(px, false), y.seen(py, false)}, height) -
                   factor_from_origin({x.seen(px, true), y.seen(py, true)}, height);
        });
    });
}

}  // namespace

TiledWalls draw_tiled_walls(std::size_t n, stats::Draws& draws) {
    const auto between = [&](double low, double high) { return low + (high - low) * draws.uniform(); };
    const auto size = static_cast<double>(n);
    const double height = size * between(0.3, 1.5);
    const double plate_height = height * between(0.2, 0.8);
    Rectangle plate;
    for (Range& range : plate) {
        const double width = size * std::exp(between(std::log(0.02), std::log(0.7)));
        range.low = between(0, size - width);
        range.high = range.low + width;
    }
    TiledWalls walls;
    const auto tile = [&](std::size_t k) {
        const std::size_t row_index = k / n;
        const auto column = static_cast<double>(k % n);
        const auto row = static_cast<double>(row_index);
        return Rectangle{Range{column, column + 1}, Range{row, row + 1}};
    };
    const std::size_t tiles = n * n;
    for (std::size_t k = 0; k < 2 * tiles; ++k) {
        walls.scene.surfaces.push_back(k < tiles ? level_surface(tile(k), 0, 1, k)
                                                 : level_surface(tile(k - tiles), height, -1, k));
    }
    walls.scene.surfaces.push_back(level_surface(plate, plate_height, -1, 2 * tiles));
    for (std::size_t k = 0; k <= 2 * tiles; ++k) walls.scene.faces.push_back(fmt::format("f{}", k + 1));
    walls.scene.name = "tiled walls";
    walls.scene.canonical = fmt::format("tiled walls {} {} {}", n, height, plate_height);
    for (std::size_t i = 0; i < tiles; ++i) {
        for (std::size_t j = 0; j < tiles; ++j) {
            std::array<Axis, 2> axes;
            for (std::size_t k = 0; k < 2; ++k) axes[k] = {tile(i)[k], tile(j)[k], plate[k], height / plate_height};
            walls.across.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(tiles + j),
                                    exchange_past_plate(axes, height)});
        }
    }
    return walls;
}

}  // namespace ff::studies::form_factors
