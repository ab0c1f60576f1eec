#include "stats/shares/share_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace ff::stats {
namespace {

double probability_of(std::uint64_t hits, std::uint64_t trials, double p) {
    const double n = static_cast<double>(trials);
    const double k = static_cast<double>(hits);
    const double log_choose = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    return std::exp(log_choose) * std::pow(p, k) * std::pow(1 - p, n - k);
}

/// The exact rate at which "at most `difference` above the reference" is rejected at `alpha`, all outcomes counted.
double rejection_rate(double p, std::uint64_t trials, double reference, std::uint64_t reference_trials,
                      double difference, double alpha) {
    double rate = 0;
    for (std::uint64_t hits = 0; hits <= trials; ++hits) {
        for (std::uint64_t other = 0; other <= reference_trials; ++other) {
            const ShareReference with{.counts = Proportion{other, reference_trials}};
            if (p_of_at_most({hits, trials}, with, difference) <= alpha)
                rate += probability_of(hits, trials, p) * probability_of(other, reference_trials, reference);
        }
    }
    return rate;
}

TEST(ShareTest, IsTheBinomialTailForAnExactReference) {
    // By fractions: the sum of C(100, k) 0.2^k 0.8^(100 - k) over k = 30 to 100
    EXPECT_NEAR(p_of_at_most({30, 100}, {.value = 0.1}, 0.1), 0.011248978720991635, 1e-12);
    EXPECT_NEAR(p_of_at_least({70, 100}, {.value = 0.9}, -0.1), 0.011248978720991635, 1e-12);
    EXPECT_EQ(p_of_at_most({0, 100}, {.value = 0.1}, 0.1), 1);
    EXPECT_EQ(p_of_at_most({1, 100}, {.value = 0}, 0), 0) << "a hit where there can be none";
    EXPECT_EQ(p_of_at_least({99, 100}, {.value = 1}, 0), 0) << "a miss where there can be none";
}

TEST(ShareTest, KeepsItsLevelForTwoSharesWhateverTheyAre) {
    for (const double difference : {0.0, 0.1}) {
        for (const double reference : {0.0, 0.01, 0.1, 0.5, 0.85}) {
            for (const double alpha : {0.05, 1e-3}) {
                EXPECT_LE(rejection_rate(reference + difference, 12, reference, 30, difference, alpha), alpha)
                    << difference << " above " << reference;
            }
        }
    }
    EXPECT_GT(rejection_rate(0.9, 12, 0.1, 30, 0.1, 0.05), 0.9) << "it rejects what is far off";
}

TEST(ShareTest, HasIntervalsThatEndWhereThePValueDoes) {
    const std::vector<ShareReference> references{{.value = 0.2},
                                                 {.value = 0.2, .standard_error = 0.03},
                                                 {.value = 0.2, .standard_error = 0.03, .freedom = 7},
                                                 {.counts = Proportion{0, 40}},
                                                 {.counts = Proportion{9, 40}},
                                                 {.counts = Proportion{40, 40}}};
    for (const ShareReference& reference : references) {
        for (const std::uint64_t hits : {0u, 1u, 15u, 49u, 50u}) {
            const double level = 0.98;
            const Interval interval = share_difference_interval({hits, 50}, reference, level);
            const double tail = (1 - level) / 2;
            const double step = 1e-6;
            if (hits > 0) {
                EXPECT_LE(p_of_at_most({hits, 50}, reference, interval.low - step), tail);
                EXPECT_GE(p_of_at_most({hits, 50}, reference, interval.low + step), tail);
            }
            if (hits < 50) {
                EXPECT_LE(p_of_at_least({hits, 50}, reference, interval.high + step), tail);
                EXPECT_GE(p_of_at_least({hits, 50}, reference, interval.high - step), tail);
            }
        }
    }
}

TEST(BinomialScatter, HasPValuesByChiSquaredOrByCountingRareHits) {
    // 20 runs of 100 trials. SciPy: chi2.sf(dispersion, 19)
    std::vector<Proportion> even(20, Proportion{30, 100});
    EXPECT_NEAR(p_of_binomial_scatter(even), 1, 1e-12);
    std::vector<Proportion> bursts(20, Proportion{20, 100});
    for (std::size_t i = 0; i < 10; ++i) bursts[i].hits = 40;
    EXPECT_LT(p_of_binomial_scatter(bursts), 1e-4);
    // Four hits in one of ten runs: 10 * 0.1^4, by counting.
    std::vector<Proportion> rare(10, Proportion{0, 1000});
    rare[3].hits = 4;
    EXPECT_NEAR(p_of_binomial_scatter(rare), 1e-3, 1e-9);
    for (Proportion& run : rare) run.hits = 1000 - run.hits;
    EXPECT_NEAR(p_of_binomial_scatter(rare), 1e-3, 1e-9);
    EXPECT_EQ(p_of_binomial_scatter(std::vector<Proportion>(5, Proportion{0, 10})), 1);
}

}  // namespace
}  // namespace ff::stats
