#include "stats/basics/binomial.hpp"

#include <gtest/gtest.h>
#include <boost/math/distributions/binomial.hpp>

#include <algorithm>

namespace ff::stats {
namespace {

/// Exact coverage of an interval method at one probability, by summing over all outcomes.
template <class Method>
double exact_coverage(Method method, std::uint64_t trials, double probability) {
    const boost::math::binomial law(static_cast<double>(trials), probability);
    double sum = 0;
    for (std::uint64_t hits = 0; hits <= trials; ++hits) {
        if (method(Proportion{hits, trials}, 0.95).contains(probability)) sum += pdf(law, static_cast<double>(hits));
    }
    return sum;
}

// Clopper-Pearson by mpmath: findroot(lambda p: betainc(3, 623, 0, p, regularized=True) - mpf('.025'), 9.9e-4) and
// findroot(lambda p: betainc(4, 622, 0, p, regularized=True) - mpf('.975'), (.0138, .0141), solver='anderson')
// Wilson: from scipy.stats import binomtest; binomtest(10, 100).proportion_ci(.95, 'wilson')
TEST(BinomialIntervals, AgreeWithMpmathAndScipy) {
    const auto exact = clopper_pearson_interval({3, 625}, 0.95);
    EXPECT_NEAR(exact.low, 0.0009909713786849134, 1e-16);
    EXPECT_NEAR(exact.high, 0.0139630460989825657, 1e-16);
    const auto wilson = wilson_interval({10, 100}, 0.95);
    EXPECT_NEAR(wilson.low, 0.05522913706067508, 1e-14);
    EXPECT_NEAR(wilson.high, 0.17436566150491345, 1e-14);
    EXPECT_EQ(wilson.method, "wilson");
    EXPECT_EQ(exact.n, 625u);
}

// 1 - mpf('.025')**(mpf(1)/625)
TEST(ClopperPearson, UpperBoundIsPositiveWithoutHits) {
    EXPECT_EQ(clopper_pearson_interval({0, 625}, 0.95).low, 0);
    EXPECT_NEAR(clopper_pearson_interval({0, 625}, 0.95).high, 0.00588482331985753633, 1e-16);
    EXPECT_EQ(wilson_interval({0, 625}, 0.95).low, 0);
    EXPECT_NEAR(wilson_interval({0, 625}, 0.95).high, 0.006108787464328854, 1e-14);
    EXPECT_EQ(wald_interval({0, 625}, 0.95).width(), 0);  // which is why Wald's is not used
}

// mpf('.025')**(mpf(1)/100)
TEST(BinomialIntervals, ReachOneWithoutMisses) {
    EXPECT_EQ(clopper_pearson_interval({100, 100}, 0.95).high, 1);
    EXPECT_NEAR(clopper_pearson_interval({100, 100}, 0.95).low, 0.963783307354823581, 1e-14);
    EXPECT_EQ(wilson_interval({100, 100}, 0.95).high, 1);
    EXPECT_EQ(clopper_pearson_interval({1, 1}, 0.95).high, 1);
}

TEST(ClopperPearson, NeverCoversBelowItsLevel) {
    double least = 1;
    for (const std::uint64_t trials : {1u, 5u, 30u, 100u}) {
        for (int i = 1; i < 400; ++i)
            least = std::min(least, exact_coverage(clopper_pearson_interval, trials, i / 400.0));
    }
    EXPECT_GE(least, 0.95 - 1e-12);
    EXPECT_LT(least, 0.96);  // and is not simply the whole of [0, 1]
}

TEST(Wilson, CoversNearItsLevelOnAverageWhereWaldDoesNot) {
    double wilson = 0;
    double wald = 0;
    constexpr int points = 399;
    for (int i = 1; i <= points; ++i) {
        const double p = i / 400.0;
        wilson += exact_coverage(wilson_interval, 30, p);
        wald += exact_coverage(wald_interval, 30, p);
    }
    EXPECT_NEAR(wilson / points, 0.95, 0.01);
    EXPECT_LT(wald / points, 0.89);
}

// The sums are exact, so the figures are facts, not measurements.
TEST(Wald, CoversRareHitsAtFortySixAndEightyOnePercent) {
    EXPECT_NEAR(exact_coverage(wald_interval, 625, 0.001), 0.46, 0.005);
    EXPECT_NEAR(exact_coverage(wald_interval, 625, 0.005), 0.81, 0.005);
    EXPECT_GT(exact_coverage(wilson_interval, 625, 0.001), 0.93);
    EXPECT_GT(exact_coverage(wilson_interval, 625, 0.005), 0.93);
}

// from scipy.stats import binomtest; binomtest(k, n, p).pvalue
TEST(BinomialTest, AgreesWithScipy) {
    const auto close = [](Proportion counts, double p, double expected) {
        EXPECT_NEAR(binomial_two_sided_p(counts, p) / expected, 1, 1e-9);
    };
    close({3, 625}, 0.01, 0.30760844830007655);
    close({10, 100}, 0.05, 0.03410882338375014);
    close({60, 100}, 0.5, 0.05688793364098088);
    close({7, 10}, 0.3, 0.010592078399999996);
    close({0, 20}, 0.3, 0.0010589696700355874);
    close({50, 100}, 0.5, 1);
    close({200, 1'000'000}, 1e-4, 1.247165631812488e-18);
    close({0, 1}, 0.5, 1);
    close({1, 1}, 0.5, 1);
}

TEST(BinomialTest, EqualsTheSumOverAllOutcomesNoMoreLikely) {
    for (const double p : {0.03, 0.5, 0.7, 0.999}) {
        const boost::math::binomial law(40, p);
        for (unsigned hits = 0; hits <= 40; ++hits) {
            double sum = 0;
            for (unsigned other = 0; other <= 40; ++other) {
                if (pdf(law, other) <= pdf(law, hits) * (1 + 1e-7)) sum += pdf(law, other);
            }
            EXPECT_NEAR(binomial_two_sided_p({hits, 40}, p), sum, 1e-12) << hits << " at " << p;
        }
    }
}

TEST(BinomialTest, KnowsImpossibleOutcomes) {
    EXPECT_EQ(binomial_two_sided_p({1, 10}, 0), 0);
    EXPECT_EQ(binomial_two_sided_p({0, 10}, 0), 1);
    EXPECT_EQ(binomial_two_sided_p({10, 10}, 1), 1);
    EXPECT_EQ(binomial_upper_p({0, 10}, 0.5), 1);
    EXPECT_EQ(binomial_lower_p({10, 10}, 0.5), 1);
}

}  // namespace
}  // namespace ff::stats
