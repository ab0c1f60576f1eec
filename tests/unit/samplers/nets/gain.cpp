// The variance of a scrambled (t, m, s)-net in base b is at most b^t (b / (b - 1))^(s - 1) times that of as many
// independent points, whatever the integrand [owen1997] (t = 0), [pan2023] (b = 2).

#include "samplers/grids/latin_hypercube.hpp"
#include "samplers/grids/stratified.hpp"
#include "samplers/nets/faure.hpp"
#include "samplers/nets/faure_in_base.hpp"
#include "samplers/nets/padded.hpp"
#include "samplers/nets/sobol.hpp"
#include "samplers/nets/sobol_directions.hpp"
#include "samplers/nets/sobol_lms.hpp"
#include "samplers/nets/sobol_nus.hpp"
#include "samplers/random/antithetic.hpp"
#include "samplers/random/random.hpp"
#include "samplers/support/owen_hash.hpp"
#include "stats/basics/moments.hpp"
#include "tests/unit/samplers/nets/net.hpp"
#include "tests/unit/samplers/nets/scrambling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ff::test {
namespace {

using PointInCube = std::array<double, 4>;

constexpr std::uint32_t gain_replicates = 400;

/// An integrand that no net is made for, with its mean and variance.
struct Rough {
    std::string name;
    double mean;
    double variance;
    double (*value)(const PointInCube&);
};

/// Digit k (from 0) of x in a base, less its mean.
template <std::uint32_t base, int k>
double digit(double x) {
    for (int i = 0; i < k; ++i) x = x * base - std::floor(x * base);
    return std::floor(x * base) - (base - 1) / 2.0;
}

/// Functions of single digits see one gain coefficient each; the products of several are where nets may be worse than
/// independent points.
template <std::uint32_t base>
std::vector<Rough> rough_functions() {
    constexpr double v = (base * base - 1) / 12.0;  // variance of a digit
    return {
        {"digits 0, 0, 0, 0", 0, v * v * v * v,
         [](const PointInCube& x) {
             return digit<base, 0>(x[0]) * digit<base, 0>(x[1]) * digit<base, 0>(x[2]) * digit<base, 0>(x[3]);
         }},
        {"digits 1, 1, 1, 1", 0, v * v * v * v,
         [](const PointInCube& x) {
             return digit<base, 1>(x[0]) * digit<base, 1>(x[1]) * digit<base, 1>(x[2]) * digit<base, 1>(x[3]);
         }},
        {"digits 2, 1, 2, 1", 0, v * v * v * v,
         [](const PointInCube& x) {
             return digit<base, 2>(x[0]) * digit<base, 1>(x[1]) * digit<base, 2>(x[2]) * digit<base, 1>(x[3]);
         }},
        {"digits 3, 3", 0, v * v, [](const PointInCube& x) { return digit<base, 3>(x[1]) * digit<base, 3>(x[3]); }},
        {"digits 4, 0, 1", 0, v * v * v,
         [](const PointInCube& x) { return digit<base, 4>(x[0]) * digit<base, 0>(x[1]) * digit<base, 1>(x[2]); }},
        // python3 -c "from math import pi; p = pi**2 / 32; print(p, p * (1 - p))"
        {"ball", 0.30842513753404244, 0.21329907207114945,
         [](const PointInCube& x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3] < 1 ? 1.0 : 0.0; }},
        // 1 / .7, 1 / .4 - 1 / .49
        {"pole", 1 / 0.7, 1 / 0.4 - 1 / 0.49, [](const PointInCube& x) { return std::pow(x[2], -0.3); }},
    };
}

/// Measured variance over that of independent points, and its standard error.
struct Gain {
    double ratio;
    double standard_error;
};

Gain measure(Fill fill, const Rough& rough, std::size_t points) {
    std::vector<double> estimates;
    PointBlock block;
    for (std::uint32_t trial = 0; trial < gain_replicates; ++trial) {
        block.size = points;
        fill({.key = {11, 12}, .trial = trial}, block);
        double sum = 0;
        for (std::size_t i = 0; i < points; ++i) {
            PointInCube x;
            for (std::size_t d = 0; d < 4; ++d) x[d] = (block.coordinate[d][i] + 0.5) * 0x1p-32;
            sum += rough.value(x);
        }
        estimates.push_back(sum / static_cast<double>(points));
    }
    // About the known mean: 400 squares.
    double second = 0;
    double fourth = 0;
    for (const double estimate : estimates) {
        const double square = (estimate - rough.mean) * (estimate - rough.mean);
        second += square / gain_replicates;
        fourth += square * square / gain_replicates;
    }
    const double scale = static_cast<double>(points) / rough.variance;
    return {second * scale, std::sqrt((fourth - second * second) / gain_replicates) * scale};
}

template <class Sampler, std::size_t points>
void fill_with(const Stream& stream, PointBlock& block) {
    Sampler({.points = points}).fill(stream, 0, block);
}

double bound(std::uint32_t base, unsigned t, int dimension = 4) {
    return std::pow(base, t) * std::pow(base / (base - 1.0), dimension - 1);
}

/// No gain lies above the bound by more than five standard errors: a false alarm is one in 10^6 for a gain that
/// reaches the bound.
void expect_below(double bound, Fill fill, std::size_t points, const std::vector<Rough>& functions,
                  const std::string& name) {
    for (const Rough& rough : functions) {
        const Gain gain = measure(fill, rough, points);
        EXPECT_LT(gain.ratio - 5 * gain.standard_error, bound) << name << ", " << rough.name;
    }
}

template <std::uint32_t base>
void expect_within_bound(Fill fill, std::size_t points, unsigned t, const std::string& name) {
    expect_below(bound(base, t), fill, points, rough_functions<base>(), name);
}

unsigned sobol_parameter(unsigned m) {
    Coordinates points;
    for (std::uint32_t i = 0; i < 1u << m; ++i) {
        for (std::size_t d = 0; d < 4; ++d) points[d].push_back(samplers::sobol_coordinate(i, d));
    }
    return net_parameter(points, m);
}

TEST(Gain, StaysBelowItsBoundForScrambledSobolPoints) {
    expect_within_bound<2>(fill_with<samplers::Sobol, 64>, 64, sobol_parameter(6), "sobol");
    expect_within_bound<2>(fill_with<samplers::Sobol, 256>, 256, sobol_parameter(8), "sobol");
    expect_within_bound<2>(fill_with<samplers::SobolLms, 256>, 256, sobol_parameter(8), "sobol_lms");
    expect_within_bound<2>(fill_with<samplers::SobolNus, 64>, 64, sobol_parameter(6), "sobol_nus");
}

TEST(Gain, StaysBelowItsBoundForScrambledFaurePoints) {
    expect_within_bound<5>(fill_with<samplers::Faure, 125>, 125, 0, "faure");
    expect_within_bound<5>(fill_with<samplers::Faure, 625>, 625, 0, "faure");
    expect_within_bound<7>(fill_with<samplers::FaureInBase<7>, 343>, 343, 0, "faure_7");
    expect_within_bound<11>(fill_with<samplers::FaureInBase<11>, 121>, 121, 0, "faure_11");
    expect_within_bound<13>(fill_with<samplers::FaureInBase<13>, 169>, 169, 0, "faure_13");
}

TEST(Gain, IsAtMostOneForStratifiedPoints) {
    expect_below(1, fill_with<samplers::Stratified, 256>, 256, rough_functions<2>(), "stratified");  // [owen2013]
}

TEST(Gain, IsAtMostNOverNMinusOneForLatinHypercubes) {
    expect_below(64.0 / 63, fill_with<samplers::LatinHypercube, 64>, 64, rough_functions<2>(), "64");  // [owen1998]
    expect_below(2.0, fill_with<samplers::LatinHypercube, 2>, 2, rough_functions<2>(), "2");
}

TEST(Gain, IsAtMostTwoForMirroredPoints) {
    expect_below(2, fill_with<samplers::Antithetic<samplers::Random>, 64>, 64, rough_functions<2>(), "antithetic");
    // Two coordinates mirrored: their product is the same for both points of a pair, and the bound is reached.
    const Rough even{"digits 0, 0", 0, 1.0 / 16,
                     [](const PointInCube& x) { return digit<2, 0>(x[0]) * digit<2, 0>(x[1]); }};
    const Gain gain = measure(fill_with<samplers::Antithetic<samplers::Random>, 64>, even, 64);
    EXPECT_LT(std::abs(gain.ratio - 2), 5 * gain.standard_error);
}

TEST(Gain, StaysBelowTheNetBoundWithinAPairOfPaddedPoints) {
    constexpr double variance = 1.0 / 16;
    const std::vector<Rough> within{
        {"digits 0, 0", 0, variance, [](const PointInCube& x) { return digit<2, 0>(x[0]) * digit<2, 0>(x[1]); }},
        {"digits 3, 3", 0, variance, [](const PointInCube& x) { return digit<2, 3>(x[2]) * digit<2, 3>(x[3]); }},
        {"digits 5, 1", 0, variance, [](const PointInCube& x) { return digit<2, 5>(x[0]) * digit<2, 1>(x[1]); }},
        {"digits 2, 6", 0, variance, [](const PointInCube& x) { return digit<2, 2>(x[2]) * digit<2, 6>(x[3]); }},
    };
    expect_below(bound(2, 0, 2), fill_with<samplers::Padded, 64>, 64, within, "padded");
}

/// Every coordinate from the first of Sobol', each scrambled by itself: uniform points, and no net.
void fill_diagonal(const Stream& stream, PointBlock& block) {
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words multipliers = philox(stream, 1, Purpose::scramble);
    for (std::size_t d = 0; d < 4; ++d) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] =
                samplers::owen_scramble(samplers::sobol_coordinate(i, 0), {addends[d], multipliers[d]});
        }
    }
}

TEST(Gain, ExceedsTheBoundForPointsOnADiagonal) {
    const Rough digits = rough_functions<2>().front();
    const Gain gain = measure(fill_diagonal, digits, 256);
    EXPECT_GT(gain.ratio - 5 * gain.standard_error, bound(2, 3));
    EXPECT_NEAR(gain.ratio, 256, 1e-9) << "the product of first digits is the same for all points";
}

TEST(Gain, IsOneForIndependentPoints) {
    const auto fill = [](const Stream& stream, PointBlock& block) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            const Words words = philox(stream, i, Purpose::coordinates);
            for (std::size_t d = 0; d < 4; ++d) block.coordinate[d][i] = words[d];
        }
    };
    for (const Rough& rough : rough_functions<2>()) {
        const Gain gain = measure(fill, rough, 64);
        EXPECT_LT(std::abs(gain.ratio - 1), 5 * gain.standard_error) << rough.name;
        EXPECT_LT(gain.standard_error, 0.2) << rough.name;
    }
}

}  // namespace
}  // namespace ff::test
