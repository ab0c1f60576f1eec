#pragma once

#include <span>

namespace ff::stats {

/// One p-value for "every one of these null hypotheses holds". Each asks for less than Holm's smallest adjusted
/// p-value, and names no hypothesis. @pre not empty, all p in [0, 1]

/// min of m p_(i) / i: valid where the tests are independent or positively dependent, never above Holm's smallest
/// [simes1986]. Orders `p`.
double simes(std::span<double> p);

/// The Cauchy combination, for tests that depend on each other in any way: valid in the tail, that is for levels as
/// gates have them [liu2020]. Terms of p above 1/2 are left out, since p-values of composite hypotheses are often 1 and
/// would outweigh all others; what the mean of the remaining ones then exceeds Cauchy's distribution by, ln(1 + m T) /
/// pi, is taken off.
double cauchy_combination(std::span<const double> p);

}  // namespace ff::stats
