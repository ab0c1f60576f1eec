#pragma once

#include "studies/verdicts/reported/reported_bins.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

namespace ff::studies::gates {

/// The p-value of "every effect lies in its band", of all bins together, by Hotelling's T² with the covariance that the
/// gate's file has: columns bin, other_bin and covariance, each pair once. Holds for normal means. With errors from n
/// samples, the covariance is assumed to come from the same samples.
/// @param effects  differences; not empty
/// @throws IoError; UserError where the file is malformed, lacks a pair, disagrees with the standard errors, or is not
///   a possible covariance of that many bins
double p_by_covariance(const Gate& gate, const Bins& bins, const std::vector<BinEffect>& effects);

}  // namespace ff::studies::gates
