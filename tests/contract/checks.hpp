#pragma once

#include "samplers/sampler.hpp"

#include <gtest/gtest.h>

namespace ff::test {

/// The contract of a sampler, check by check. Each is run on the whole catalogue and on samplers broken on purpose, and
/// none of them names a sampler: what is required of one follows from its SamplerInfo.
///
/// Statistical checks use the one statement that holds exactly for every randomised sampler, low-discrepancy or not: a
/// point picked at random from the set of a random stream is uniform, and independent from stream to stream.
using Check = testing::AssertionResult(const samplers::CatalogueEntry&);

Check describes_itself;         ///< name, summary, details and reference are there
Check refuses_impossible_sets;  ///< no points, too many points, no dimension: UserError
Check is_pure;                  ///< point i is the same bits from any first point and in blocks of any size
Check streams_differ;           ///< in key, trial, source and target, if and only if it is randomised
Check weights_add_up;           ///< to 1 over the set, and each is positive
Check blocks_agree;             ///< a weighted point is the centre of the 2^-32 cell of the tallied one
Check fills_its_strata;         ///< what `sizes` promises: one point per cell, or polynomials integrated exactly

Check coordinates_are_uniform;     ///< randomised ones: each coordinate by itself
Check pairs_are_uniform;           ///< randomised ones: every two coordinates of a point
Check trials_are_independent;      ///< randomised ones: estimates of successive trials are uncorrelated
Check integrates_without_bias;     ///< randomised ones: known integrals, each by itself
Check successive_points_are_free;  ///< independent ones: each coordinate of points i and i + 1 of one stream

/// A size that the sampler is made for: 256 points in 4-D, whatever it is made for.
samplers::PointSetSpec usual_spec();

}  // namespace ff::test
