#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// Rays that met nothing and all rays, by row.
using LostRays = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

/// Judges the rows of a closed scene, which add up to 1 but for gaps between its surfaces. Where none misses 1 by more
/// than the tolerance, Matrix::leak says by how much, and the intervals of entries hold what passes through the gaps;
/// otherwise the rows that miss it exclude 1.
/// @param lost  rays that met nothing and all rays, by row
/// @param add_up  every surface belongs to a face
void judge_closure(Matrix& matrix, const LostRays& lost, bool add_up, const Request& request);

/// The interval of an exchange, each half of it wider by a factor.
std::pair<double, double> widened(const FaceExchange& exchange, double factor);

/// How much wider the intervals of all sampled factors are if one of them misses with a probability of 1e-6. The
/// intervals are Student's.
double widest_by_chance(const Matrix& matrix);

}  // namespace ff::studies::form_factors
