#pragma once

#include "studies/form_factors/form_factors.hpp"

namespace ff::studies {

/// The factors nearest to the estimates, by the widths of their intervals, that are reciprocal, sum to 1 in every row
/// and are nowhere negative (core/radiosity/repair.hpp).
RepairedFactors repair(const FormFactorMatrix& matrix);

}  // namespace ff::studies
