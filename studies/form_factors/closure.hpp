#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// Judges the rows of a closed scene, which add up to 1 but for gaps between its surfaces. Where none misses 1 by more
/// than the tolerance, Matrix::leak says by how much, and the intervals of entries hold what passes through the gaps;
/// otherwise the rows that miss it exclude 1.
/// @param lost  rays that met nothing and all rays, by row
void judge_closure(Matrix& matrix, const std::vector<std::pair<std::uint64_t, std::uint64_t>>& lost,
                   const Request& request);

}  // namespace ff::studies::form_factors
