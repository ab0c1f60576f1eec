#pragma once

#include "studies/heat/heat.hpp"

#include <optional>
#include <vector>

namespace ff::studies::heat {

/// Chooses half widths that cost least among those for which the half width of every power is about a tolerance.
///
/// To first order the half width of a power is a sum over pairs of faces: half width of the pair, times how much of
/// what it changes is absorbed in the end by the face (the adjoint solution), times how far the radiosity at its other
/// end is from the row's weighted median (rows add up to 1, so that errors only move radiation between faces). Samples
/// are taken to grow as 1 / half width, from what each pair took. For one face's power the best half widths follow by
/// Lagrange's rule; for all powers together faces are weighted, with more weight for those whose power is known worst,
/// until that no longer helps.
/// @param floor  of the half widths
/// @return for each exchange of the matrix, as a form factor of its smaller face, 0 for those that are exact; empty
///   where the mean factors determine no flows
std::optional<std::vector<double>> plan_flows(const Scene& scene, const form_factors::Matrix& matrix,
                                              const Materials& materials, double scale, const FlowTolerance& tolerance,
                                              double floor);

/// Estimate of the samples that one tolerance for all form factors would take for powers as certain as those of a
/// matrix. @param matrix  has been sampled by a plan @param first  an earlier one: no pair takes fewer samples than
/// there
/// @return empty where nothing is sampled, or powers do not depend on what is
std::optional<double> even_samples(const Scene& scene, const form_factors::Matrix& matrix,
                                   const form_factors::Matrix& first, const Materials& materials, double scale);

}  // namespace ff::studies::heat
