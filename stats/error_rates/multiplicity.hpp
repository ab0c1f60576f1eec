#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ff::stats {

/// Adjusted p-values, in the order given, each at most 1: reject those at most alpha. @pre all p in [0, 1]

/// Family-wise error rate, any dependence, never less powerful than Bonferroni. For gates. @see [holm1979]
std::vector<double> holm(std::span<const double> p);
/// Family-wise error rate for independent (or positively dependent two-sided normal) tests; 1 - (1-p)^m without
/// cancellation for small p. @see [sidak1967]
std::vector<double> sidak(std::span<const double> p);
/// The level per test at which the family has `alpha`: 1 - (1 - alpha)^(1/tests). @pre tests >= 1
double sidak_level(double alpha, std::size_t tests);
/// alpha / tests.
double bonferroni_level(double alpha, std::size_t tests);

/// One p-value for "every one of these null hypotheses holds". All are less strict than Holm's smallest adjusted
/// p-value, but do not tell which hypothesis fails. @pre not empty, all p in [0, 1]

/// min of m p_(i) / i: valid where the tests are independent or positively dependent, never above Holm's smallest
/// [simes1986]. Orders `p`.
double simes(std::span<double> p);

/// The Cauchy combination, for tests that depend on each other in any way: valid in the tail, i.e. at the small
/// levels of gates [liu2020]. Terms of p above 1/2 are left out, since p-values of composite hypotheses are often 1
/// and would outweigh all others; the excess of the remaining mean over Cauchy's distribution, ln(1 + m T) / pi, is
/// subtracted.
double cauchy_combination(std::span<const double> p);

/// The sum of the chi-squared values, of one degree of freedom each, that have these p-values: for independent tests,
/// whatever their distributions are. It finds small effects in many of them [lancaster1961].
double chi_squared_combination(std::span<const double> p);

}  // namespace ff::stats
