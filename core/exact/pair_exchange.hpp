#pragma once

#include "core/exact/exchange_method.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/occluders.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff {

/// The knowledge about the exchange area A_1 F_12 of two surfaces before sampling.
struct PairExchange {
    ExchangeMethod method = ExchangeMethod::none;
    ExchangeReason reason = ExchangeReason::turned_away;
    /// The exchange area; for sampled pairs the unoccluded one, an upper bound, where that is known.
    std::optional<BoundedValue<double>> area = BoundedValue<double>{};
    std::vector<Blocker> blockers;  ///< only for ExchangeMethod::cells; they belong to Occluders::walls
};

/// The cheapest method for two surfaces of a scene (which may be one and the same).
/// @param from, to  indices of the surfaces
/// @param wanted upper limit of the error, an exchange area; extended precision is used where needed
PairExchange pair_exchange(const Occluders& occluders, std::size_t from, std::size_t to, double wanted);

/// The same for two surfaces that face each other, where it is known what stands between them.
PairExchange pair_exchange(const Surface& from, const Surface& to, const Occluders::Between& between, double wanted);

}  // namespace ff
