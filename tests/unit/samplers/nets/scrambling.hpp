#pragma once

#include "core/points/points.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

// Checks whether two scramblings have the same effect on estimates. For a few integrands, smooth and not: both means
// are right, and both variances agree.

namespace ff::test {

/// A way to scramble: fills `block.size` points from the first one on.
using Fill = void (*)(const Stream&, PointBlock&);

/// A known integral over [0, 1)^4.
struct Integral {
    std::string name;
    double value;
    double (*integrand)(double, double, double, double);
};

/// How gtest prints a parameter.
// NOLINTNEXTLINE(readability-identifier-naming): gtest's name
inline void PrintTo(const Integral& integral, std::ostream* out) {
    *out << integral.name;
}

/// Two smooth integrands and two discontinuous ones.
std::vector<Integral> scrambling_integrals();

/// 1000 independent estimates from sets of `points` points.
std::vector<double> scrambled_estimates(Fill fill, const Integral& integral, std::size_t points);

/// Estimates scatter around the value: a bias of 1 % is noticed, a false alarm is one in 10^6.
testing::AssertionResult has_mean(const std::vector<double>& estimates, const Integral& integral);

/// The variances of two samples agree (by their ratio, with the kurtosis of the estimates): a false alarm is one in
/// 10^6. With 1000 roughly normal estimates, variances that differ by a factor of 1.7 are noticed with probability
/// above .99 (the logarithm of their ratio has standard deviation .063; 4.9 + 2.3 of them are a factor of 1.58).
bool have_same_variance(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ff::test
