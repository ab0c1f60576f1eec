#pragma once

#include "stats/skewed_reach.hpp"

#include <span>

namespace ff::stats {

/// How far the limits of a mean lie from it, in standard errors, where the values may be skewed.
///
/// The studentised mean of values with a long upper tail falls low too often: a sample that missed the tail has too
/// small a mean and too small a spread. Its quantile is that of Student's t, corrected for the skewness by Hall's cubic
/// transformation [hall1992] and, at least, by the first term of its expansion [johnson1978]. The skewness is the
/// sample's plus three of its standard errors towards the side in question, since few values hardly show it. Neither
/// limit is ever closer than Student's.
using gate::SkewedReach;

/// @param effective  number of independent values: all of them, or fewer in a correlated series; at least 2
/// @param freedom    of the standard error       @param tail  beyond each limit, in (0, 0.5)
/// @pre values are at least 3 and not all equal
SkewedReach reach_of_mean(std::span<const double> values, double effective, double freedom, double tail);

}  // namespace ff::stats
