#pragma once

#include <compare>

namespace ff::studies {

/// The kind of quantity in a row of results.
enum class QuantityKind { form_factor, row_sum, sum_relative_error };

/// A quantity with one value per trial of a cell. Faces count from 1; 0 for none.
struct Quantity {
    QuantityKind kind = QuantityKind::form_factor;
    int from = 0;
    int to = 0;
    auto operator<=>(const Quantity&) const = default;
};

}  // namespace ff::studies
