#pragma once

#include "core/geometry/scene.hpp"
#include "core/points/stream.hpp"
#include "studies/form_factors/division/sampled_share.hpp"
#include "studies/form_factors/face_pairs.hpp"

#include <cstdint>
#include <optional>

namespace ff::studies::form_factors {

/// An estimate and what it took.
struct CellSum {
    SampledSum sum;
    std::uint64_t evaluations = 0;
};

/// The exchange area of a pair of faces by Gauss's rule in cells of the source in which the factor to what is seen of
/// the target is smooth (`smooth_parts`), halved where the rule is not yet good enough. Random places, one in each cell
/// and randomisation, measure what the interpolant that the rule integrates leaves of the factor, so that the estimate
/// is unbiased whatever the factor does. The visible part is integrated or the hidden one, whichever is smoother.
/// A round source with nothing between is halved until its cells are small beside their distance from the target.
/// @param pair  of surfaces of which one at least is a polygon, past polygons (FacePair::by_points)
/// @param wanted  half width
/// @return nothing where both are round or one is and something stands between, where what is seen changes along too
/// many lines, or where too many cells would
///         be needed
std::optional<CellSum> cell_sum(const Scene& scene, const FacePair& pair, PointEffort effort, double wanted,
                                StreamKey key);

}  // namespace ff::studies::form_factors
