#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ff {

/// How the exchange area of two surfaces can be found, the cheapest method first.
enum class ExchangeMethod : std::uint8_t {
    none,         ///< they do not face each other: exactly 0
    closed_form,  ///< elementary formulas (core/exact/exact.hpp)
    contour,      ///< contour integrals with a bound (core/formulas/polygon_exchange.hpp, disc_exchange.hpp)
    quadrature,   ///< Gauss's rule with a bound, of pairs far apart (core/formulas/far_exchange.hpp)
    remainder,    ///< what is missing of a row's sum
    bounds,       ///< not computed: 0 and the unoccluded value are close enough to each other
    cells,        ///< Gauss's rule where what is seen changes smoothly, and random places that measure what it leaves,
                  ///< with exact factors to what they see (studies/form_factors/cells)
    points,       ///< the same where what is seen may change anywhere: places may miss what geometry does not exclude
    rays,         ///< sampled rays; always possible
};

/// Their names, in order.
inline constexpr std::array<std::string_view, 9> exchange_methods{
    "none", "closed_form", "contour", "quadrature", "remainder", "bounds", "cells", "points", "rays"};

constexpr std::string_view name(ExchangeMethod method) {
    return exchange_methods.at(static_cast<std::size_t>(method));
}

/// Why a pair of surfaces is computed by its method.
enum class ExchangeReason : std::uint8_t {
    turned_away,    ///< they cannot see each other
    aligned,        ///< rectangles along the axes that nothing can stand between
    polygons,       ///< polygons that nothing can stand between
    far,            ///< polygons that nothing can stand between, small beside their distance
    small,          ///< little passes, whatever stands in between
    blocked,        ///< polygons past polygons that may stand in between
    curved,         ///< a surface is curved, or a possible occluder is
    many_blockers,  ///< more possible occluders than can be cut out of a polygon
    covers,         ///< one of them covers a part of the other
    leaves,         ///< received by the surroundings of an open scene
    many_surfaces,  ///< the scene has too many surfaces to find the possible occluders of each pair
    round,          ///< a disc and a flat surface, or a sphere and any, never occluded
    coaxial,        ///< surfaces about one axis that see each other wholly
};

/// The reasons in words, in order.
inline constexpr std::array<std::string_view, 13> exchange_reasons{
    "cannot see each other",
    "aligned rectangles, unoccluded",
    "polygons, unoccluded",
    "polygons far apart, unoccluded",
    "less than the tolerance, even if unoccluded",
    "polygons, possibly occluded",
    "something is curved",
    "many possible occluders",
    "one covers a part of the other",
    "leaves the scene",
    "too many surfaces to look at each pair",
    "with a disc or a sphere, unoccluded",
    "round surfaces about one axis, unoccluded",
};

constexpr std::string_view in_words(ExchangeReason reason) {
    return exchange_reasons.at(static_cast<std::size_t>(reason));
}

}  // namespace ff
