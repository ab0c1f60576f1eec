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

}  // namespace ff::stats
