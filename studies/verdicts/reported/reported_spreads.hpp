#pragma once

#include "studies/verdicts/reported/reported_effects.hpp"

namespace ff::studies::gates {

/// The standard deviation of a sample over the gate's reference, in each bin, from the standard errors of means.
/// @throws UserError where the file does not say of how many samples
void compare_spreads(BinComparison& comparing);

/// The efficiency over that of a second file.
/// @throws UserError where a file has several runs, or does not say of how many samples
void compare_efficiencies(BinComparison& comparing, const Bins& against);

}  // namespace ff::studies::gates
