#pragma once

#include "studies/verdicts/reported/reported_quantity.hpp"

#include <string>

namespace ff::studies::gates {

/// Common mistakes of codes in reporting a mean and its error, recognised by the size of the discrepancy. Hints, never
/// verdicts: a sentence with a full stop, empty where nothing fits.

/// @param ratio  spread of means between runs over the errors stated    @param error  a typical one as stated
/// @param n      samples behind a mean; 0 where not stated
std::string fault_of_errors(double ratio, double error, double n);

/// Sums instead of means: one file's values are n times the other's, in all bins together.
/// @pre rows of the same bins in the same order; `against` may have one row only
std::string fault_of_means(Rows rows, Rows against);

/// Variances instead of standard errors in one of two files.
std::string fault_between_errors(Rows rows, Rows against);

}  // namespace ff::studies::gates
