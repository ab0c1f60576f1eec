#pragma once

#include "core/geometry/fwd.hpp"
#include "core/radiosity/flow_bounds.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/heat.hpp"

#include <functional>
#include <optional>

namespace ff::studies::heat {

/// The flows for irradiations within limits.
using FlowsOf = std::function<Flows(const IrradiationBounds&)>;

/// Flows with statistical intervals.
///
/// Sampled factors have 16 independent randomisations, so that any quantity has a jackknife: computed from all of them,
/// and 16 times with one left out, it has pseudo-values whose mean is free of the bias that grows as 1 / 16, and whose
/// spread gives Student's interval with 15 degrees of freedom, however factors depend on each other. In a closed scene
/// the factors are balanced each time (reciprocal, rows of 1), which takes away most of their errors. What no spread
/// shows is added to first order: the intervals of other factors, all in the worst way, and in each row the largest
/// effect of what points may have missed.
/// @return empty where no factor has randomisations, or none that balance, and where the first order is not enough
/// @see [efron1982]
std::optional<Flows> statistical_flows(const Scene& scene, const form_factors::Matrix& matrix,
                                       const Materials& materials, double scale, const FlowIntervals& intervals,
                                       const FlowsOf& flows_of);

}  // namespace ff::studies::heat
