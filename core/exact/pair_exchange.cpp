#include "core/exact/pair_exchange.hpp"

#include "core/exact/coaxial_exchange.hpp"
#include "core/exact/exact.hpp"
#include "core/formulas/disc_exchange.hpp"
#include "core/formulas/far_exchange.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/formulas/sphere_exchange.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>

namespace ff {
namespace {

/// Each blocker is cut out of every piece of a polygon; with more blockers, rays cost less.
constexpr std::size_t most_blockers = 256;

BoundedValue<double> contour_exchange(const Surface& from, const Surface& to, double wanted) {
    const auto brief = polygon_exchange_area<double>(corners_of<double>(from), corners_of<double>(to));
    if (brief.error <= wanted) return brief;
    const auto exact = polygon_exchange_area<long double>(corners_of<long double>(from), corners_of<long double>(to));
    return {static_cast<double>(exact.value), static_cast<double>(exact.error) + 1e-16 * brief.value};
}

bool are_polygons(const Surface& from, const Surface& to) {
    return is_polygon(from.shape) && is_polygon(to.shape);
}

/// The exchange of surfaces with nothing in between: of polygons by the cheapest method whose error is at most
/// `wanted`; if no method comes so close, by the most accurate one.
PairExchange clear_exchange(const Surface& from, const Surface& to, double wanted) {
    if (!are_polygons(from, to)) {
        constexpr double digits_for_little = 1e-5;  // costs a few more nodes
        auto area = disc_exchange_area(from, to, digits_for_little * wanted);
        if (!area) area = sphere_exchange_area(from, to, digits_for_little * wanted);
        if (area && area->error <= wanted) return {ExchangeMethod::contour, ExchangeReason::round, area, {}};
        return {ExchangeMethod::rays, ExchangeReason::curved, std::nullopt, {}};
    }
    PairExchange best{.area = std::nullopt, .blockers = {}};
    const auto is_good = [&](ExchangeMethod method, ExchangeReason reason, const BoundedValue<double>& area) {
        if (!best.area || area.error < best.area->error) best = {method, reason, area, {}};
        return best.area->error <= wanted;
    };
    const double extent = squared_extent(from, to);
    const auto closed_form = exact_exchange_area(from, to);
    if (closed_form &&
        is_good(ExchangeMethod::closed_form, ExchangeReason::aligned, {std::max(0.0, *closed_form), 1e-15 * extent}))
        return best;
    if (!closed_form && is_good(ExchangeMethod::contour, ExchangeReason::polygons, contour_exchange(from, to, wanted)))
        return best;
    const auto far = far_exchange_area(from, to);
    if (far && is_good(ExchangeMethod::quadrature, ExchangeReason::far, *far)) return best;
    if (closed_form) {
        const double exact = *extended_exchange_area(from, to);
        if (!is_good(ExchangeMethod::closed_form, ExchangeReason::aligned, {exact, 1e-18 * extent + 1e-16 * exact}))
            is_good(ExchangeMethod::contour, ExchangeReason::polygons, contour_exchange(from, to, wanted));
    }
    return best;
}

}  // namespace

PairExchange pair_exchange(const Occluders& occluders, std::size_t from_index, std::size_t to_index, double wanted) {
    const Surface& from = occluders.surfaces()[from_index];
    const Surface& to = occluders.surfaces()[to_index];
    if (!occluders.face_each_other(from_index, to_index)) return {};
    return pair_exchange(from, to, occluders.between(from_index, to_index), wanted);
}

PairExchange pair_exchange(const Surface& from, const Surface& to, const Occluders::Between& between, double wanted) {
    if (between.all_hidden) return {};
    const std::vector<Blocker>& blockers = between.occluders;
    const auto coaxial = coaxial_exchange_area(from, to, blockers);
    if (coaxial && coaxial->error <= wanted) return {ExchangeMethod::closed_form, ExchangeReason::coaxial, coaxial, {}};
    PairExchange result = clear_exchange(from, to, wanted);
    // A hollow end stands in its own way, but for what lies in front of all of it, as here.
    const auto is_an_end = [&](const Blocker& blocker) {
        const Shape& shape = blocker.surface->shape;
        return result.reason == ExchangeReason::round && (shape == from.shape || shape == to.shape);
    };
    if (result.method != ExchangeMethod::rays && std::ranges::all_of(blockers, is_an_end)) return result;
    // Places on a curved surface see a polygon just as well.
    const bool has_polygon = is_polygon(from.shape) || is_polygon(to.shape);
    const auto is_flat_sided = [](const Blocker& blocker) { return is_polygon(blocker.surface->shape); };
    const bool cut_out = has_polygon && std::all_of(blockers.begin(), blockers.end(), is_flat_sided);
    result.method = cut_out ? ExchangeMethod::cells : ExchangeMethod::rays;
    result.reason = cut_out && are_polygons(from, to) ? ExchangeReason::blocked : ExchangeReason::curved;
    if (blockers.size() > most_blockers) {
        result.method = ExchangeMethod::rays;
        result.reason = ExchangeReason::many_blockers;
    }
    if (result.method == ExchangeMethod::cells) result.blockers = blockers;
    return result;
}

}  // namespace ff
