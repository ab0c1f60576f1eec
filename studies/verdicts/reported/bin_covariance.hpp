#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/reported/reported_bins.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

#include <vector>

namespace ff::studies::gates {

/// The p-value of "every effect lies in its band", of all bins together, by Hotelling's T² with the covariance that the
/// gate's file has: columns bin, other_bin and covariance, each pair once. The file gives correlations, the effects
/// their variances, and what the digits of the file leave open is added to these. Holds for normal means. With errors
/// from n samples, the covariance is assumed to come from the same samples.
/// @param effects  differences; not empty
/// @throws IoError; UserError where the file is malformed, lacks a pair, disagrees with the standard errors, or is not
///   a possible covariance of that many bins
double p_by_covariance(const Gate& gate, const Bins& bins, const std::vector<BinEffect>& effects);

}  // namespace ff::studies::gates
