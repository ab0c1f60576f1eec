#pragma once

#include "core/geometry/fwd.hpp"
#include "core/points/stream.hpp"
#include "studies/form_factors/cells/divided_source.hpp"
#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <cstdint>

namespace ff::studies::form_factors {

/// An estimate and its cost.
struct CellSum {
    SampledSum sum;
    std::uint64_t evaluations = 0;
    bool between_lines = true;  ///< all cells lie between lines; otherwise some belong to a source that is not cut
    bool at_limit = false;      ///< the division reached its limit
};

/// The exchange area of a pair of faces by Gauss's rule in cells of the source (`DividedSource`). Random places in each
/// cell measure what the interpolant that the rule integrates leaves of the factor, so that the estimate is unbiased
/// whatever the factor does. The visible part is integrated or the hidden one, whichever is smoother.
/// @param pairs  all of them @param pair  polygons on one side at least, past polygons (FacePair::by_cells)
CellSum cell_sum(const Scene& scene, const FacePairs& pairs, const FacePair& pair, const CellLimits& limits,
                 StreamKey key);

}  // namespace ff::studies::form_factors
