#pragma once

#include "studies/heat/heat.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies::heat {

/// Flows that have been sampled until they were known well enough.
struct SampledFlows {
    form_factors::Matrix matrix;  ///< form factors that the flows are computed from
    Flows flows;
    FlowTolerance tolerance;
    double factor_tolerance = 0;  ///< the smallest tolerance of its form factors
    std::size_t matrices = 0;     ///< number of matrices that were sampled, including the pilot
    std::uint64_t samples = 0;    ///< rays and evaluations in cells for all of them
};

/// Tolerances of a matrix that flows are computed from.
struct FlowPlan {
    /// One for each exchange of the matrix that it was made from, as a form factor of the smaller face; 0 for those
    /// that are exact.
    std::vector<double> tolerances;
    bool even = false;  ///< they are all the same
};

/// Chooses half widths that cost least among those for which the half width of every power is about a tolerance.
///
/// To first order the half width of a power is a sum over pairs of faces: half width of the pair, times how much of
/// what it changes is absorbed in the end by the face (the adjoint solution), times how far the radiosity at its other
/// end is from the row's weighted median (rows add up to 1, so that errors only move radiation between faces). Samples
/// are taken to grow as 1 / half width, from what each pair took. For one face's power the best half widths follow by
/// Lagrange's rule; for all powers together faces are weighted, with more weight for those whose power is known worst,
/// until that no longer helps.
/// @param floor  of the half widths
/// Unless they are expected to cost less than half of one tolerance for all factors, the plan is that.
/// @return empty where the mean factors determine no flows
std::optional<FlowPlan> plan_flows(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials,
                                   double scale, const FlowTolerance& tolerance, double floor);

/// Samples the form factors on which flows depend until every power is within its tolerance: a coarse matrix first,
/// then matrices by plan_flows, most_matrices in all, each with random numbers of its own. They share the error rate,
/// so that it does not matter which of them is reported: the one whose powers are known best.
/// @param request  with LevelOf::matrix; its tolerance is not used @throws UserError as find_flows
SampledFlows sample_flows(const Scene& scene, const form_factors::Request& request, const Materials& materials,
                          double scale, const FlowTolerance& tolerance, const FlowIntervals& intervals = {});

}  // namespace ff::studies::heat
