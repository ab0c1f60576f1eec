#pragma once

#include "studies/theory/known_variance.hpp"

namespace ff::test {

/// In short: {pair, 1, 6} is the `studies::Quantity` F 1-6.
inline constexpr studies::QuantityKind pair = studies::QuantityKind::form_factor;

}  // namespace ff::test
