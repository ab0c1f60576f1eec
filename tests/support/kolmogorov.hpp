#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ff::test {

/// P(D_n > d), D_n the two-sided Kolmogorov-Smirnov distance of n values from their continuous distribution. Exact up
/// to n = 2000 [marsaglia2003], with the tail from Smirnov's one-sided law [simard2011]; asymptotic with a correction
/// of order 1/n beyond [vrbik2018]. @pre n >= 1
double kolmogorov_tail(std::size_t n, double d);

struct KolmogorovTest {
    double distance = 0;
    double p = 0;
};

/// Test of uniformity on [0, 1], e.g. of the p-values of another test. Empty without values.
std::optional<KolmogorovTest> test_uniformity(std::span<const double> values);

}  // namespace ff::test
