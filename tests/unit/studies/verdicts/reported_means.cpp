#include "studies/verdicts/reported/reported_gates.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

Gate gate_of_means(GateKind kind, Band band) {
    Gate gate;
    gate.name = "g";
    gate.quantity = "flux";
    gate.kind = kind;
    gate.band = band;
    gate.against = kind == GateKind::std ? Against::number : Against::file;
    gate.reference = 1;
    return gate;
}

GateResult judged_means(const Gate& gate, const ReportedFile& file, const ReportedFile* against = nullptr,
                        double alpha = 1e-4) {
    Spec spec;
    spec.alpha = alpha;
    spec.gates = {gate};
    return judge_reported(spec, gate, file, against);
}

TEST(GatesOnMeans, DoNotTakeAnEmptyBinOfTheOtherFileForAnExactValue) {
    const auto means = [](const char* rows, const char* origin) {
        return parse_reported(std::string("quantity,bin,mean,standard_error,n\n") + rows, origin,
                              StandardErrors::required);
    };
    const auto old = means("flux,0,0,0,10000\nflux,1,1,0.001,10000\n", "old.csv");
    const auto rare = means("flux,0,2e-4,4.5e-5,100000\nflux,1,1.0002,0.001,100000\n", "new.csv");
    const auto hits = parse_reported("quantity,bin,hits,n\nflux,0,20,100000\nflux,1,99990,100000\n", "hits.csv",
                                     StandardErrors::required);
    for (const GateKind kind : {GateKind::equal, GateKind::bias}) {
        const Gate gate = gate_of_means(kind, {-1e-5, 1e-5});
        for (const ReportedFile* file : {&rare, &hits}) {
            const auto result = judged_means(gate, *file, &old);
            EXPECT_EQ(result.verdict, Verdict::inconclusive) << file->origin;
            EXPECT_EQ(result.compared, 1u) << file->origin;
            EXPECT_THAT(result.note, HasSubstr("1 bin that no sample fell into")) << file->origin;
        }
    }
    const auto exact = parse_reported("quantity,bin,mean\nflux,0,0\nflux,1,1\n", "exact.csv", StandardErrors::optional);
    EXPECT_EQ(judged_means(gate_of_means(GateKind::bias, {-1e-5, 1e-5}), rare, &exact).verdict, Verdict::fail)
        << "a reference of 0 without a standard error is exact";
    const auto none = means("flux,0,0,0,10000\nflux,1,0,0,10000\n", "none.csv");
    EXPECT_THAT(test::message_of<UserError>([&] {
                    judged_means(gate_of_means(GateKind::equal, {-1, 1}), rare, &none);
                }),
                HasSubstr("no bin of 'flux' in new.csv holds anything that is also in none.csv"));
}

/// The mean of 1000 samples of a law, with its standard error times a factor.
template <class Law>
ReportedFile samples_of(std::uint64_t seed, Law law, double factor = 1) {
    constexpr int samples = 1000;
    std::mt19937_64 engine(seed);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < samples; ++i) {
        const double value = law(engine);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / samples;
    const double error = factor * std::sqrt((squares / samples - mean * mean) / (samples - 1));
    return parse_reported(fmt::format("quantity,mean,standard_error,n\nflux,{},{},{}\n", mean, error, samples),
                          "means.csv", StandardErrors::required);
}

TEST(GatesOnMeans, JudgeSpreadsByADeclaredKurtosisOnly) {
    const auto old = samples_of(1, std::normal_distribution<double>(5, 1));
    Gate spread = gate_of_means(GateKind::std, {1 / 1.5, 1.5});
    Gate efficiency = gate_of_means(GateKind::efficiency, {1 / 1.5, std::numeric_limits<double>::infinity()});
    const auto verdicts = [&](double factor) {
        const auto file = samples_of(2, std::normal_distribution<double>(5, 1), factor);
        return std::pair(judged_means(spread, file).verdict, judged_means(efficiency, file, &old).verdict);
    };
    EXPECT_EQ(verdicts(3), std::pair(Verdict::inconclusive, Verdict::inconclusive));
    EXPECT_EQ(verdicts(1), std::pair(Verdict::inconclusive, Verdict::inconclusive));
    const auto open = judged_means(spread, samples_of(2, std::normal_distribution<double>(5, 1), 3));
    EXPECT_THAT(open.note, HasSubstr("add kurtosis = 3"));
    EXPECT_NEAR(open.comparisons.at(0).measurement->value, 3, 0.3);
    EXPECT_FALSE(open.comparisons.at(0).measurement->failing.is_finite());
    spread.kurtosis = efficiency.kurtosis = 3;
    EXPECT_EQ(verdicts(3), std::pair(Verdict::fail, Verdict::fail));
    EXPECT_EQ(verdicts(1), std::pair(Verdict::pass, Verdict::pass));
}

/// Ten bins of so many runs, whose means are values of a law; errors are not stated.
template <class Law>
ReportedFile runs_of_bins(std::uint64_t seed, int runs, Law law) {
    std::mt19937_64 engine(seed);
    std::string text = "quantity,bin,run,mean\n";
    for (int bin = 0; bin < 10; ++bin) {
        for (int run = 0; run < runs; ++run) text += fmt::format("flux,{},{},{}\n", bin, run, law(engine));
    }
    return parse_reported(text, "runs.csv", StandardErrors::optional);
}

// Of 400 sound files at 1 %, more than 12 fail with probability 3e-4. By Student's t, 48 of 400 such files fail. Normal
// runs that are 3 of their standard deviations off (13 standard errors) are found in at least 380 of 400.
TEST(GatesOnMeans, AllowForSkewedRunsInEveryBin) {
    Gate gate = gate_of_means(GateKind::bias, {-1e-6, 1e-6});
    gate.against = Against::number;
    const auto failures = [&](auto law) {
        int found = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed)
            found += judged_means(gate, runs_of_bins(seed, 20, law), nullptr, 0.01).verdict == Verdict::fail ? 1 : 0;
        return found;
    };
    EXPECT_LE(failures(std::exponential_distribution<double>(1)), 12);
    EXPECT_GE(failures(std::normal_distribution<double>(1.3, 0.1)), 380);
}

// A mean of 0.2 that is summed up from shares of it is not 0.2, and had a standard error of 1e-17.
TEST(GatesOnMeans, RefuseABinWhoseRunsAreAllEqual) {
    Gate gate = gate_of_means(GateKind::bias, {-1e-3, 1e-3});
    gate.against = Against::number;
    for (const int runs : {10, 12, 13, 37}) {
        std::string text = "quantity,bin,run,mean\n";
        for (int run = 0; run < runs; ++run) text += fmt::format("flux,a,{0},0.2\nflux,b,{0},{1}\n", run, run % 7);
        const auto file = parse_reported(text, "runs.csv", StandardErrors::optional);
        EXPECT_THROW(judged_means(gate, file), UserError) << runs;
    }
}

// A sum of squares over bins is for normal means. Of 200 files of normal runs more than 8 are called otherwise with
// probability 1e-4 (0.7 % each); nearly all of exponential runs are, whose sums of squares would fail 13 times as often
// as stated, and of runs on two sides.
TEST(GatesOnMeans, JudgeNoSumOfSquaresOfRunsThatAreNotNormal) {
    Gate gate = gate_of_means(GateKind::bias, {-1e-6, 1e-6});
    gate.against = Against::number;
    gate.combine = Combination::chi_squared;
    const auto refused = [&](auto law) {
        int found = 0;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
            found += judged_means(gate, runs_of_bins(seed, 20, law), nullptr, 0.01).note.find("are not normal") !=
                             std::string::npos
                         ? 1
                         : 0;
        return found;
    };
    EXPECT_LE(refused(std::normal_distribution<double>(1, 1)), 8);
    EXPECT_GE(refused(std::exponential_distribution<double>(1)), 195);
    const auto on_two_sides = [](auto& engine) {
        return std::normal_distribution<double>(engine() % 2 == 0 ? -1 : 1, 0.1)(engine);
    };
    EXPECT_GE(refused(on_two_sides), 195);
}

// Errors of three values are known badly, whatever the other runs say: the degrees of freedom are those of their sum.
TEST(GatesOnMeans, DoNotDependOnTheOrderOfRunsOfDifferentSizes) {
    Gate gate = gate_of_means(GateKind::bias, {-1e-6, 1e-6});
    gate.against = Against::number;
    const auto judged = [&](const std::string& rows) {
        const auto file =
            parse_reported("quantity,run,mean,standard_error,n\n" + rows, "m.csv", StandardErrors::required);
        return judged_means(gate, file, nullptr, 0.01).comparisons.at(0).measurement->failing;
    };
    const auto large_first = judged("flux,1,1.1,0.01,1000\nflux,2,1.3,0.3,3\n");
    const auto small_first = judged("flux,1,1.3,0.3,3\nflux,2,1.1,0.01,1000\n");
    EXPECT_DOUBLE_EQ(large_first.low, small_first.low);
    // Half the root of 0.3² + 0.01², by Welch's 2.0044 degrees of freedom at 0.005 beyond each end.
    EXPECT_NEAR(large_first.width() / 2, 1.48400, 1e-4);
}

// Exponential samples have kurtosis 9: of 2000 sound files at 1 %, more than 40 fail with probability 3e-5, and at the
// end of a band, where 5 % may pass, more than 140 pass with probability 5e-5. Taken for normal, one in ten or more
// fails: this shows that the test would see it.
TEST(GatesOnMeans, SizeIntervalsOfSpreadsByTheKurtosis) {
    const auto count = [](double kurtosis, double factor, double end, Verdict verdict) {
        Gate gate = gate_of_means(GateKind::std, {1 / (1 + end), 1 + end});
        gate.kurtosis = kurtosis;
        int found = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            const auto file = samples_of(seed, std::exponential_distribution<double>(1), factor);
            found += judged_means(gate, file, nullptr, 0.01).verdict == verdict ? 1 : 0;
        }
        return found;
    };
    EXPECT_LE(count(9, 1, 1e-9, Verdict::fail), 40);
    EXPECT_GE(count(3, 1, 1e-9, Verdict::fail), 200);
    EXPECT_LE(count(9, 1.2, 0.2, Verdict::pass), 140);
}

TEST(GatesOnMeans, CountRunsAndEvents) {
    const auto counted = [](const GateResult& result) { return result.comparisons.at(0).unit; };
    const auto old = samples_of(1, std::normal_distribution<double>(1));
    EXPECT_EQ(counted(judged_means(gate_of_means(GateKind::equal, {-1, 1}),
                                   samples_of(2, std::normal_distribution<double>(1)), &old)),
              "run");
    const auto events =
        parse_reported("quantity,bin,count\nflux,0,400\nflux,1,600\n", "a.csv", StandardErrors::required);
    const auto shares =
        parse_reported("quantity,bin,share\nflux,0,0.4\nflux,1,0.6\n", "b.csv", StandardErrors::optional);
    EXPECT_EQ(counted(judged_means(gate_of_means(GateKind::distribution, {0, 0.5}), events, &shares)), "event");
}

}  // namespace
}  // namespace ff::studies::gates
