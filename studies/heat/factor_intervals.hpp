#pragma once

#include "core/geometry/fwd.hpp"
#include "core/radiosity/flow_bounds.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies::heat {

/// Intervals of the factors in which all rows can add up to 1, if chance explains those that cannot.
struct PossibleFactors {
    FactorBounds bounds;
    std::vector<std::size_t> widened;  ///< rows
};

PossibleFactors possible_factors(const Scene& scene, const form_factors::Matrix& matrix);

/// Whether a face may see out of the scene, by more than the rounding of a row of exact factors.
bool sees_out(const FactorBounds& factors, Eigen::Index face);
bool sees_out(const FactorBounds& factors);

}  // namespace ff::studies::heat
