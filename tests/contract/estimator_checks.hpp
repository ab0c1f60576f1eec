#pragma once

#include "core/configurations/catalogue.hpp"
#include "core/estimators/estimator.hpp"

#include <gtest/gtest.h>

namespace ff::test {

/// The contract of an estimator, check by check. Each is run on the whole catalogue and on estimators broken on
/// purpose, and none of them names an estimator: what is required of one follows from its declaration.
using EstimatorCheck = testing::AssertionResult(const EstimatorEntry&);

EstimatorCheck declares_itself;  ///< name, summary, details and reference; points that fit the dimension; a cost
EstimatorCheck says_why_not;     ///< a refusal of a scene of the catalogue has a reason and what to do instead
EstimatorCheck
    depends_on_its_task;  ///< the same task gives the same bits, another trial others in some scene if it takes points

/// The mean over 32 trials or more, as many as their spread asks for, of 1024 random points for each patch, or 64 for
/// each pair of patches, of faces divided in four is the exact value of a configuration. Fails for a right estimator
/// with probability 1e-8; a bias of `noticed_bias` goes unnoticed with probability .01 at most, which is checked as
/// well. Succeeds without a test where the estimator refuses the scene or has no variance there. An estimator that
/// takes no points has to be right to 1e-12; one that makes its own, to `noticed_bias` with 10 000 points from each of
/// 8 x 8 patches.
testing::AssertionResult is_unbiased(const EstimatorEntry& estimator, const Configuration& configuration);

/// 0.03 sqrt(F): that is 15 standard errors of 262 144 rays.
double noticed_bias(double factor);

}  // namespace ff::test
