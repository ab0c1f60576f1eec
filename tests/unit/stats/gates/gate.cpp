#include "stats/gates/gate.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/means/mean_test.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace ff::gate {
namespace {

/// Tails are solved to 1e-8 in the logarithm by steps that converge quadratically; what is left is the rounding of
/// powers of freedom / 2, Boost's too: 1e-10 below 1e6 degrees of freedom.
void expect_as_boost(double ours, double boost, double digits, double freedom, double tail) {
    EXPECT_NEAR(ours / boost, 1, std::pow(10, -digits)) << "freedom " << freedom << ", tail " << tail;
}

constexpr std::array tail_probabilities{0.499, 0.4, 0.1, 0.05, 1e-2, 1e-4, 1e-6, 1e-10, 1e-14};

TEST(GateQuantiles, MatchBoostForTheNormalDistribution) {
    for (const double tail : tail_probabilities) {
        expect_as_boost(normal_critical(tail), stats::normal_critical(tail), 10, 0, tail);
        expect_as_boost(normal_critical(1 - tail), stats::normal_critical(1 - tail), 10, 0, 1 - tail);
    }
    EXPECT_EQ(normal_critical(0.5), 0);
}

TEST(GateQuantiles, MatchBoostForStudentsDistribution) {
    for (const double freedom : {1.0, 1.7, 2.0, 3.0, 5.0, 9.0, 29.0, 99.0, 1000.0, 1e5, 1e7}) {
        for (const double tail : tail_probabilities)
            expect_as_boost(student_critical(freedom, tail), stats::student_critical(freedom, tail),
                            freedom > 1e6 ? 9 : 10, freedom, tail);
    }
}

TEST(GateQuantiles, MatchBoostForChiSquared) {
    for (const double freedom : {1.0, 1.7, 2.0, 3.0, 5.0, 9.0, 29.0, 99.0, 1000.0, 1e5}) {
        for (const double tail : tail_probabilities) {
            const double digits = freedom > 1e4 ? 8 : 10;
            expect_as_boost(chi_squared_critical(freedom, tail), stats::chi_squared_critical(freedom, tail), digits,
                            freedom, tail);
            // 1 - tail has fewer digits than tail.
            expect_as_boost(chi_squared_critical(freedom, 1 - tail), stats::chi_squared_critical(freedom, 1 - tail),
                            tail < 1e-4 ? 2 : digits, freedom, 1 - tail);
        }
    }
}

std::vector<double> normal_trials(std::size_t n, std::uint64_t seed, double mean = 0) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(mean, 1);
    std::vector<double> values(n);
    for (double& value : values) value = normal(engine);
    return values;
}

Options band(double width) {
    Options options;
    options.band = width;
    return options;
}

TEST(GateOnAMean, GivesTheThreeVerdictsAndSaysWhy) {
    EXPECT_TRUE(mean(normal_trials(100, 1), 0, band(0.8)));
    const Result failed = mean(normal_trials(100, 2, 3), 0, band(0.8));
    EXPECT_EQ(failed.verdict, Verdict::fail);
    EXPECT_NE(message(failed).find("FAIL: effect 2.83, interval 2.64"), std::string::npos) << message(failed);
    const Result open = mean(normal_trials(100, 3), 0, band(0.01));
    EXPECT_EQ(open.verdict, Verdict::inconclusive);
    EXPECT_NE(message(open).find("pass with that power if there is no effect"), std::string::npos) << message(open);
}

/// A line of tests/data/gate_cases.csv, which tests/frameworks/test_cases.py reads too.
struct Case {
    std::string name;
    double reference = 0;
    Options options;
    std::string verdict;
    double effect = 0;
    double low = 0;
    double high = 0;
    std::vector<double> trials;
};

std::vector<Case> read_cases() {
    std::ifstream file(FF_TEST_DATA "/gate_cases.csv");
    std::vector<Case> cases;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::string text;
        const auto number = [&] { return std::getline(cells, text, ','), std::stod(text); };
        Case& one = cases.emplace_back();
        std::getline(cells, one.name, ',');
        one.reference = number();
        for (double* option :
             {&one.options.band, &one.options.alpha, &one.options.pass_alpha, &one.options.reference_error})
            *option = number();
        std::getline(cells, one.verdict, ',');
        for (double* found : {&one.effect, &one.low, &one.high}) *found = number();
        for (double trial = 0; cells >> trial;) one.trials.push_back(trial);
    }
    return cases;
}

bool agrees(double found, double expected) {
    return found == expected || std::abs(found - expected) <= 1e-9 * (1 + std::abs(expected));
}

TEST(GateOnAMean, AgreesWithTheSharedCases) {
    const auto cases = read_cases();
    ASSERT_EQ(cases.size(), 12u);
    for (const Case& one : cases) {
        const Result found = mean(one.trials, one.reference, one.options);
        EXPECT_EQ(name(found.verdict), one.verdict) << one.name;
        EXPECT_TRUE(agrees(found.effect, one.effect)) << one.name << ": " << found.effect;
        EXPECT_TRUE(agrees(found.low, one.low)) << one.name << ": " << found.low;
        EXPECT_TRUE(agrees(found.high, one.high)) << one.name << ": " << found.high;
    }
}

/// The program's intervals (studies/verdicts/measurement.cpp).
TEST(GateOnAMean, AgreesWithTheProgram) {
    for (const Case& one : read_cases()) {
        const auto own = stats::mean_evidence(one.trials, one.reference);
        ASSERT_TRUE(own) << one.name;
        const double error = one.options.reference_error;
        const auto evidence = stats::with_uncertain_reference(*own, error, std::numeric_limits<double>::infinity());
        const auto passing = stats::interval_of(evidence, 1 - 2 * one.options.pass_alpha);
        const auto failing = stats::interval_of(evidence, 1 - one.options.alpha);
        const detail::Range band{-one.options.band, one.options.band};
        EXPECT_EQ(name(judge(passing, failing, band)), one.verdict) << one.name;
        if (error == 0) {
            EXPECT_TRUE(agrees(passing.low, one.low)) << one.name << ": " << passing.low;
            EXPECT_TRUE(agrees(passing.high, one.high)) << one.name << ": " << passing.high;
        } else {  // the header keeps the skewness that the trials have alone
            EXPECT_GE(passing.low, one.low - 1e-9) << one.name;
            EXPECT_LE(passing.high, one.high + 1e-9) << one.name;
        }
    }
}

TEST(GateOnAMean, IsUndecidedWhereTrialsSupportNoInterval) {
    EXPECT_STREQ(mean(std::vector<double>(50, 1.0), 1, band(1)).fault,
                 "every trial gave the same value: was each seeded alike?");
    EXPECT_STREQ(mean(normal_trials(9, 1), 0, band(1)).fault, "fewer than 10 trials; 50 to 200 are usual");
    EXPECT_STREQ(mean({1, 0, 100}, 1, band(1)).fault, "a standard error has to be positive, of at least 2 values");
    auto broken = normal_trials(50, 1);
    broken[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_STREQ(mean(broken, 0, band(1)).fault, "a value is not finite");
    EXPECT_NE(*mean(normal_trials(50, 1), 0, band(0)).fault, 0);
    EXPECT_EQ(mean(normal_trials(50, 1), 0, band(0)).verdict, Verdict::inconclusive);
}

TEST(GateOnAMean, AllowsForTheErrorOfTheReference) {
    Options options = band(0.5);
    const auto trials = normal_trials(100, 4);
    EXPECT_TRUE(mean(trials, 0, options));
    options.reference_error = 0.4;
    EXPECT_FALSE(mean(trials, 0, options));
}

/// How often normal trials whose mean lies at `effect` have the verdict, among `times` seeds.
int count(double effect, const Options& options, Verdict verdict, int times) {
    int found = 0;
    for (int seed = 0; seed < times; ++seed)
        found +=
            mean(normal_trials(60, 1000 + static_cast<std::uint64_t>(seed), effect), 0, options).verdict == verdict;
    return found;
}

TEST(GateOnAMean, KeepsBothRisks) {
    // A point null: the failing interval may be left at both ends, with alpha = 5 %; of 2000 at most 150 (SciPy:
    // binom.sf(150, 2000, .05) = 5e-7).
    Options options = band(1e-6);
    options.alpha = 0.05;
    EXPECT_LE(count(0, options, Verdict::fail, 2000), 150);
    // An effect at the end of the band passes in at most 5 %.
    options.band = 2;
    EXPECT_LE(count(2, options, Verdict::pass, 2000), 150);
    // One far outside fails: (3.5 - 2) sqrt(60) = 11.6 standard errors beyond.
    EXPECT_EQ(count(3.5, options, Verdict::fail, 200), 200);
}

TEST(GateOnAMean, PassesWithTheStatedPowerAtTheTrialsItAsksFor) {
    // 60 trials are asked for a band of sigma * 3.29 / sqrt(60 - 1.35); skewness's share of the interval needs a little
    // more room, 10 %. Fewer than 85 % of 1000 has probability 2e-7 at 90 % (SciPy: binom.cdf(850, 1000, .9)).
    const double width = 1.1 * (2 * 1.6449) / std::sqrt(60 - 1.35);
    EXPECT_GE(count(0, band(width), Verdict::pass, 1000), 850);
}

TEST(GateOnAStatedError, TrustsTheStatedError) {
    EXPECT_TRUE(mean({1, 0.01, 100}, 1, band(0.1)));
    EXPECT_EQ(mean({2, 0.01, 100}, 1, band(0.1)).verdict, Verdict::fail);
    EXPECT_EQ(mean(Estimate{1, 0.1}, 1, band(0.1)).verdict, Verdict::inconclusive);
}

TEST(GateOnASpread, GivesTheThreeVerdicts) {
    EXPECT_TRUE(spread(normal_trials(300, 5), 1, band(0.5)));
    EXPECT_EQ(spread(normal_trials(300, 5), 3, band(0.5)).verdict, Verdict::fail);
    EXPECT_EQ(spread(normal_trials(20, 5), 1, band(0.1)).verdict, Verdict::inconclusive);
    EXPECT_NE(*spread(normal_trials(20, 5), 0, band(0.1)).fault, 0);
}

// Log-normal trials whose spread is the reference: of 300 gates at α = 1e-4 more than 2 fail with probability 5e-6;
// without an allowance for skewness 7 of 100 do.
TEST(GateOnASpread, DoesNotFailForSkewedTrials) {
    std::lognormal_distribution<double> law;
    const double sigma = std::sqrt(std::expm1(1.0) * std::exp(1.0));
    int failed = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        std::mt19937_64 engine(seed);
        std::vector<double> trials(30);
        for (double& trial : trials) trial = law(engine);
        failed += spread(trials, sigma, band(0.1)).verdict == Verdict::fail ? 1 : 0;
    }
    EXPECT_LE(failed, 2);
}

}  // namespace
}  // namespace ff::gate
