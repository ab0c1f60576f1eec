#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::stats {
namespace {

void expect_close(double actual, double expected) {
    EXPECT_NEAR(actual / expected, 1, 1e-10);
}

// from scipy import stats
// stats.norm.isf(1e-20), stats.norm.sf(10), 2*stats.norm.sf(8.5), stats.t.isf(.025, 4), 2*stats.t.sf(12, 20),
// stats.chi2.isf(.05, 30), stats.chi2.sf(250, 30), stats.f.sf(4.5, 1, 18)
TEST(Distributions, AgreeWithScipy) {
    expect_close(normal_critical(1e-20), 9.262340089798409);
    expect_close(normal_tail(10), 7.61985302416047e-24);
    expect_close(student_critical(4, 0.025), 2.7764451051977996);
    expect_close(student_two_sided_p(-12, 20), 1.3595557025880677e-10);
    expect_close(chi_squared_critical(30, 0.05), 43.77297182574217);
    expect_close(chi_squared_tail(250, 30), 1.5157414203687308e-36);
    expect_close(fisher_tail(4.5, 1, 18), 0.048037527740947154);
}

// stats.ncx2.sf(15, 3, 2), .cdf(.5, 3, 2), .sf(9500, 1000, 8000), .cdf(8500, 1000, 8000), .sf(21500, 10000, 10000)
TEST(Distributions, HaveTheTailsOfNoncentralChiSquared) {
    expect_close(noncentral_chi_squared_tail(15, 3, 2, true), 0.020698949537531063);
    expect_close(noncentral_chi_squared_tail(0.5, 3, 2, false), 0.03283956190317825);
    expect_close(noncentral_chi_squared_tail(9500, 1000, 8000, true), 0.0036936537419317715);
    expect_close(noncentral_chi_squared_tail(8500, 1000, 8000, false), 0.003011820243562718);
    EXPECT_NEAR(noncentral_chi_squared_tail(21500, 1e4, 1e4, true) / 1.007094634350099e-09, 1, 0.01);
    // For a large lambda the square root is normal: 1e10 + 8e5 lies 4 of its standard deviations away.
    EXPECT_NEAR(noncentral_chi_squared_tail(1e10 + 8e5, 3, 1e10, true) / normal_tail(4), 1, 1e-3);
    EXPECT_EQ(noncentral_chi_squared_tail(0, 3, 2, true), 1);
    EXPECT_EQ(noncentral_chi_squared_tail(1e9, 3, 1, true), 0);
}

TEST(Distributions, KeepTheFarTailThatOneMinusCdfLoses) {
    expect_close(normal_two_sided_p(8.5), 1.89590696444065e-17);
    expect_close(normal_two_sided_p(-8.5), 1.89590696444065e-17);
    EXPECT_EQ(1 - (1 - normal_tail(8.5)), 0);  // what 1 - cdf would say
    EXPECT_GT(normal_tail(37), 0);
    EXPECT_DOUBLE_EQ(normal_two_sided_p(0), 1);
}

TEST(Distributions, AreContinuousWhereManyDegreesOfFreedomAreApproximated) {
    for (const double tail : {1e-14, 1e-4, 0.3, 0.9}) {
        const auto agree = [&](double below, double above) {
            EXPECT_NEAR(std::log(above) / std::log(below), 1, 1e-6) << tail;
        };
        agree(chi_squared_tail(chi_squared_critical(0.99e8, tail), 0.99e8), tail);
        agree(chi_squared_critical(0.999'999e8, tail) / 0.999'999e8 + 1,
              chi_squared_critical(1.000'001e8, tail) / 1.000'001e8 + 1);
        agree(fisher_critical(tail, 10, 0.99e8) + 1, fisher_critical(tail, 10, 1.01e8) + 1);
        agree(fisher_critical(tail, 0.99e8, 10) + 1, fisher_critical(tail, 1.01e8, 10) + 1);
    }
}

TEST(Distributions, ReachFisherQuantilesWhereBoostGivesUp) {
    for (const double above : {0.5, 523.0, 1e15}) {
        for (const double below : {0.5, 40.0, 1e22}) {
            for (const double tail : {1e-14, 0.5, 1 - 1e-14}) {
                const double f = fisher_critical(tail, above, below);
                EXPECT_GT(f, 0) << above << ' ' << below << ' ' << tail;
                EXPECT_TRUE(std::isfinite(f)) << above << ' ' << below << ' ' << tail;
            }
        }
    }
}

}  // namespace
}  // namespace ff::stats
