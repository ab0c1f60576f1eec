#pragma once

#include "studies/heat/heat.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ff::studies::heat {

/// Flows that have been sampled until they were known well enough.
struct SampledFlows {
    form_factors::Matrix matrix;  ///< form factors that the flows are computed from
    Flows flows;
    FlowTolerance tolerance;
    double factor_tolerance = 0;  ///< the smallest tolerance of its form factors
    bool is_planned = false;      ///< the matrix was sampled by a plan: it is not the pilot
    std::size_t matrices = 0;     ///< number of matrices that were sampled, including the pilot
    std::uint64_t samples = 0;    ///< rays and evaluations in cells for all of them
    /// Estimate of what one tolerance of all form factors would have taken for flows as certain.
    std::optional<double> even_samples{};
};

/// Samples the form factors on which flows depend until every power is within its tolerance: a coarse matrix first,
/// then matrices by plan_flows, most_matrices in all, each with random numbers of its own. They share the error rate,
/// so that it does not matter which of them is reported: the one whose powers are known best.
/// @param request  with LevelOf::matrix; its tolerance is not used @throws UserError as find_flows
SampledFlows sample_flows(const Scene& scene, const form_factors::Request& request, const Materials& materials,
                          double scale, const FlowTolerance& tolerance);

}  // namespace ff::studies::heat
