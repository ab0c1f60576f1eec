#include "stats/distributions.hpp"

#include <gtest/gtest.h>

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

TEST(Distributions, KeepTheFarTailThatOneMinusCdfLoses) {
    expect_close(normal_two_sided_p(8.5), 1.89590696444065e-17);
    expect_close(normal_two_sided_p(-8.5), 1.89590696444065e-17);
    EXPECT_EQ(1 - (1 - normal_tail(8.5)), 0);  // what 1 - cdf would say
    EXPECT_GT(normal_tail(37), 0);
    EXPECT_DOUBLE_EQ(normal_two_sided_p(0), 1);
}

}  // namespace
}  // namespace ff::stats
