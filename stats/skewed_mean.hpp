#pragma once

#include <span>

namespace ff::stats {

/// How far the limits of a mean lie from it, in standard errors, where the values may be skewed.
///
/// The studentised mean of values with a long upper tail falls low too often: a sample that missed the tail has too
/// small a mean and too small a spread. Its quantile is that of Student's t, corrected for the skewness by Hall's cubic
/// transformation [hall1992] and, at least, by the first term of its expansion [johnson1978]. The skewness is the
/// sample's plus three of its standard errors towards the side in question, since few values hardly show it. Neither
/// limit is ever nearer than Student's.
struct SkewedReach {
    double below = 0;  ///< of the lower limit; long lower tails widen it
    double above = 0;  ///< of the upper limit
    /// The sample is so skewed for its size that the transformation has left its range at one of the limits: a mean
    /// beyond it shows nothing at so small a tail. Below 30 values, which hardly show symmetry, so is every sample at
    /// tails as small as 1e-4.
    bool below_is_open = false;
    bool above_is_open = false;
};

/// @param effective  values that are independent: all of them, or fewer of a correlated series; at least 2
/// @param freedom    of the standard error       @param tail  beyond each limit, in (0, 0.5)
/// @pre values are at least 3 and not all equal
SkewedReach reach_of_mean(std::span<const double> values, double effective, double freedom, double tail);

}  // namespace ff::stats
