#pragma once

#include <compare>

namespace ff::studies {

/// What a row of results is about.
enum class QuantityKind { form_factor, row_sum, sum_relative_error };

/// A quantity that every trial of a cell gives one value of. Faces count from 1; 0 where there is none.
struct Quantity {
    QuantityKind kind = QuantityKind::form_factor;
    int from = 0;
    int to = 0;
    auto operator<=>(const Quantity&) const = default;
};

}  // namespace ff::studies
