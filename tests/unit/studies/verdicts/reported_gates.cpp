#include "studies/verdicts/reported/reported_gates.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

constexpr double reported_sigma = 1e-3;

/// `bins` bins of mean 1 and error `reported_sigma`, stated `factor` times as large.
ReportedFile file_of_bins(std::size_t bins, std::size_t runs, std::uint64_t seed, double factor = 1, double bias = 0) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    std::string text = "quantity,bin,run,mean,standard_error,n\n";
    for (std::size_t run = 0; run < runs; ++run) {
        for (std::size_t bin = 0; bin < bins; ++bin)
            text += fmt::format("flux,{},{},{},{},1000\n", bin, run, 1 + reported_sigma * (bias + normal(engine)),
                                factor * reported_sigma);
    }
    return parse_reported(text, "file.csv", StandardErrors::required);
}

Gate reported_gate(GateKind kind, Band band) {
    Gate gate;
    gate.name = "g";
    gate.quantity = "flux";
    gate.kind = kind;
    gate.band = band;
    gate.place = "bands.toml:5:8";
    gate.against = Against::file;
    return gate;
}

GateResult judged(const Gate& gate, const ReportedFile& file, const ReportedFile* against = nullptr) {
    Spec spec;
    spec.gates = {gate};
    return judge_reported(spec, gate, file, against);
}

TEST(JudgeReported, ComparesTwoFilesBinByBin) {
    const Gate gate = reported_gate(GateKind::equal, {-0.01, 0.01});
    const auto old = file_of_bins(100, 1, 1);
    EXPECT_EQ(judged(gate, file_of_bins(100, 1, 2), &old).verdict, Verdict::pass);
    EXPECT_EQ(judged(gate, file_of_bins(100, 1, 3, 1, 20), &old).verdict, Verdict::fail);
    const auto result = judged(reported_gate(GateKind::equal, {-1e-4, 1e-4}), file_of_bins(100, 1, 4), &old);
    EXPECT_EQ(result.verdict, Verdict::inconclusive);
    EXPECT_EQ(result.compared, 100u);
    EXPECT_THAT(result.note, HasSubstr("trusts the standard errors"));
}

TEST(JudgeReported, PrefersTheSpreadOfRunsToStatedErrors) {
    // Errors stated a hundred times too small: in ten runs their spread decides, two show that something is wrong.
    Gate gate = reported_gate(GateKind::bias, {-1e-5, 1e-5});
    gate.against = Against::number;
    gate.reference = 1;
    EXPECT_EQ(judged(gate, file_of_bins(20, 1, 5, 0.01)).verdict, Verdict::fail);
    const auto two = judged(gate, file_of_bins(20, 2, 5, 0.01));
    EXPECT_EQ(two.verdict, Verdict::inconclusive);
    EXPECT_THAT(two.note, HasSubstr("the 2 runs of "));
    EXPECT_THAT(two.note, HasSubstr("as much as the errors that they state"));
    EXPECT_EQ(judged(gate, file_of_bins(20, 12, 5, 0.01)).verdict, Verdict::inconclusive);
}

// On average, 3 of 3000 files with right errors are contradicted by chance; more than 12 are with probability 2e-5.
// Errors stated a tenth as large are overlooked in 0.004 of files of five runs, and in more than 6 of 200 such files
// with probability 2e-5.
TEST(JudgeReported, FindsErrorsThatFewRunsContradict) {
    Gate gate = reported_gate(GateKind::bias, {-1, 1});
    gate.against = Against::number;
    gate.reference = 1;
    const auto contradicted = [&](std::size_t files, std::size_t runs, double factor) {
        std::size_t count = 0;
        for (std::uint64_t seed = 1; seed <= files; ++seed)
            count += judged(gate, file_of_bins(1, runs, seed, factor)).verdict == Verdict::inconclusive ? 1u : 0u;
        return count;
    };
    EXPECT_LE(contradicted(3000, 3, 1), 12u);
    EXPECT_GE(contradicted(200, 5, 0.1), 194u);
}

TEST(JudgeReported, FindsWrongErrors) {
    const Gate gate = reported_gate(GateKind::std_error, {1 / 1.6, 1.6});
    EXPECT_EQ(judged(gate, file_of_bins(5, 100, 6)).verdict, Verdict::pass);
    EXPECT_EQ(judged(gate, file_of_bins(5, 100, 7, 0.4)).verdict, Verdict::fail);
    const auto samples = judged(gate, file_of_bins(5, 100, 8, std::sqrt(1000.0)));
    EXPECT_EQ(samples.verdict, Verdict::fail);
    EXPECT_THAT(samples.note, HasSubstr("standard deviations of single samples"));
    EXPECT_THAT(judged(gate, file_of_bins(5, 100, 9, reported_sigma)).note, HasSubstr("variances, probably"));
}

TEST(JudgeReported, WarnsWhenFilesAgreeTooClosely) {
    const auto old = file_of_bins(100, 1, 1, 10);
    EXPECT_THAT(judged(reported_gate(GateKind::equal, {-0.1, 0.1}), file_of_bins(100, 1, 2, 10), &old).note,
                HasSubstr("far below 1, so the errors are too large"));
}

TEST(JudgeReported, RefusesRunsAndFilesThatHoldTheSameNumbers) {
    const auto old = file_of_bins(10, 1, 1);
    EXPECT_THAT(
        [&] {
            judged(reported_gate(GateKind::equal, {-1, 1}), file_of_bins(10, 1, 1), &old);
        },
        testing::ThrowsMessage<UserError>(HasSubstr("has the same numbers as in file.csv")));
}

TEST(JudgeReported, RefusesDifferentBinnings) {
    const auto old = file_of_bins(10, 1, 1);
    EXPECT_THAT(
        [&] {
            judged(reported_gate(GateKind::equal, {-1, 1}), file_of_bins(11, 1, 2), &old);
        },
        testing::ThrowsMessage<UserError>(HasSubstr("bin '10' is not matched")));
    EXPECT_THAT(
        [&] {
            judged(reported_gate(GateKind::equal, {-1, 1}), file_of_bins(9, 1, 2), &old);
        },
        testing::ThrowsMessage<UserError>(HasSubstr("bin '9' is not matched")));
}

/// Bins that vary with their neighbours, at a correlation of 0.9, and their covariance in a file.
struct Correlated {
    static constexpr std::size_t bins = 20;
    test::TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "covariance.csv";

    /// @param leave_out  pairs at the end of the file
    explicit Correlated(double scale = 1, std::size_t leave_out = 0, double correlation = 0.9, int digits = 17) {
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < bins; ++i) {
            for (std::size_t j = 0; j <= i; ++j)
                lines.push_back(fmt::format("{},{},{:.{}g}\n", i, j,
                                            scale * reported_sigma * reported_sigma * (i == j ? 1 : correlation),
                                            digits));
        }
        lines.resize(lines.size() - leave_out);
        std::ofstream(file) << "bin,other_bin,covariance\n" << fmt::format("{}", fmt::join(lines, ""));
    }

    [[nodiscard]] GateResult judge(double every_second, std::uint64_t n = 0) const {
        std::mt19937_64 engine(11);
        std::normal_distribution<double> normal;
        const double common = std::sqrt(0.9) * normal(engine);
        std::string text = n > 0 ? "quantity,bin,mean,standard_error,n\n" : "quantity,bin,mean,standard_error\n";
        for (std::size_t bin = 0; bin < bins; ++bin) {
            const double score = common + std::sqrt(0.1) * normal(engine) + (bin % 2 == 0 ? every_second : 0);
            text += fmt::format("flux,{},{},{}{}\n", bin, 1 + reported_sigma * score, reported_sigma,
                                n > 0 ? fmt::format(",{}", n) : "");
        }
        Gate gate = reported_gate(GateKind::bias, {-1e-5, 1e-5});
        gate.against = Against::number;
        gate.reference = 1;
        gate.combine = Combination::chi_squared;
        gate.covariance = file;
        return judged(gate, parse_reported(text, "file.csv", StandardErrors::required));
    }
};

TEST(JudgeReported, JudgesBinsTogetherByTheirCovariance) {
    const Correlated known;
    EXPECT_EQ(known.judge(0).verdict, Verdict::inconclusive);
    EXPECT_EQ(known.judge(2).verdict, Verdict::fail);
    EXPECT_THAT(known.judge(2).note, HasSubstr("(chi_squared)"));
    // Its diagonal says about what the errors say, which are those that count.
    EXPECT_EQ(Correlated(1.04).judge(2).note, known.judge(2).note);
    // A covariance of hardly more samples than bins is worth next to nothing.
    EXPECT_EQ(known.judge(2, 22).verdict, Verdict::inconclusive);
}

TEST(JudgeReported, RefusesImpossibleCovariances) {
    const auto refusal = [](const Correlated& known, std::uint64_t n) {
        try {
            static_cast<void>(known.judge(0, n));
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(refusal(Correlated(), 20), HasSubstr("tell nothing of the covariance of 20 bins"));
    EXPECT_THAT(refusal(Correlated(1000), 0), HasSubstr("not of single samples"));
    EXPECT_THAT(refusal(Correlated(1, 2), 0), HasSubstr("no covariance of bins '19' and '18'"));
    EXPECT_THAT(refusal(Correlated(1, 210), 0), HasSubstr("no covariance of bins '0' and '0'"));
    // Five digits of 0.99999 leave open whether all bins are one.
    EXPECT_THAT(refusal(Correlated(1, 0, 0.99999, 5), 0), HasSubstr("not positive definite to its 5 digits"));
    const Correlated broken;
    std::ofstream(broken.file, std::ios::app) << "1,0,2\n";
    EXPECT_THAT(refusal(broken, 0), HasSubstr("stands here again"));
}

TEST(JudgeReported, NeverPassesWithEmptyBins) {
    const auto file = parse_reported("quantity,bin,mean,standard_error\nflux,0,1,0.001\nflux,1,0,0\n", "a.csv",
                                     StandardErrors::required);
    const auto old = parse_reported("quantity,bin,mean\nflux,0,1\nflux,1,1\n", "b.csv", StandardErrors::optional);
    const auto result = judged(reported_gate(GateKind::bias, {-0.1, 0.1}), file, &old);
    EXPECT_EQ(result.verdict, Verdict::inconclusive);
    EXPECT_THAT(result.note, HasSubstr("1 bin that no sample fell into is not judged: merge it with another"));
}

/// Hits of `trials` in each of `bins` bins and runs, of this probability, which a burst of `together` trials share.
ReportedFile file_of_hits(std::size_t bins, std::size_t runs, std::uint64_t trials, double probability,
                          std::uint64_t seed, std::uint64_t together = 1) {
    std::mt19937_64 engine(seed);
    std::binomial_distribution<std::uint64_t> hits(trials / together, probability);
    std::string text = "quantity,bin,run,hits,n\n";
    for (std::size_t run = 0; run < runs; ++run) {
        for (std::size_t bin = 0; bin < bins; ++bin)
            text += fmt::format("flux,{},{},{},{}\n", bin, run, together * hits(engine), trials);
    }
    return parse_reported(text, "hits.csv", StandardErrors::required);
}

Gate share_gate(double reference, double band) {
    Gate gate = reported_gate(GateKind::bias, {-band, band});
    gate.against = Against::number;
    gate.reference = reference;
    return gate;
}

TEST(JudgeShares, AcceptFilesWhereAllOrNoneHit) {
    EXPECT_EQ(judged(share_gate(0, 0.01), file_of_hits(20, 1, 1000, 0, 1)).verdict, Verdict::pass);
    EXPECT_EQ(judged(share_gate(1, 0.01), file_of_hits(20, 1, 1000, 1, 1)).verdict, Verdict::pass);
    EXPECT_EQ(judged(share_gate(0, 0.01), file_of_hits(20, 1, 100, 0, 1)).verdict, Verdict::inconclusive)
        << "no hit among 100 leaves 3 % possible";
    EXPECT_EQ(judged(share_gate(1, 0.01), file_of_hits(20, 1, 1000, 0, 1)).verdict, Verdict::fail);
    const auto old = file_of_hits(20, 1, 100'000, 0.3, 2);
    const Gate equal = reported_gate(GateKind::equal, {-0.02, 0.02});
    EXPECT_EQ(judged(equal, file_of_hits(20, 1, 100'000, 0.3, 3), &old).verdict, Verdict::pass);
    EXPECT_EQ(judged(equal, file_of_hits(20, 1, 100'000, 0.4, 3), &old).verdict, Verdict::fail);
    EXPECT_EQ(judged(equal, file_of_hits(20, 1, 100, 0.3, 3), &old).verdict, Verdict::inconclusive);
}

TEST(JudgeShares, FailNoMoreOftenThanStatedWhereHitsAreRare) {
    // 500 files of 50 bins with 0.3 hits expected in each, at 5 %: more than 45 are seen with a probability below 1e-4
    // where the rate is 5 %. An interval by the normal distribution fails every one of them, for bins without a hit.
    int failed = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        Spec spec;
        spec.alpha = 0.05;
        spec.gates = {share_gate(3e-4, 1e-9)};
        const auto file = file_of_hits(50, 1, 1000, 3e-4, seed);
        failed += judge_reported(spec, spec.gates[0], file, nullptr).verdict == Verdict::fail ? 1 : 0;
    }
    EXPECT_LE(failed, 45);
}

TEST(JudgeShares, AreInconclusiveWhereHitsComeInBursts) {
    const auto result = judged(share_gate(0.3, 0.1), file_of_hits(20, 10, 1000, 0.3, 5, 20));
    EXPECT_EQ(result.verdict, Verdict::inconclusive);
    EXPECT_THAT(result.note, HasSubstr("scatter more than those of independent trials"));
    EXPECT_EQ(judged(share_gate(0.3, 0.1), file_of_hits(20, 10, 1000, 0.3, 5)).verdict, Verdict::pass);
}

TEST(JudgeShares, RefuseInvalidShares) {
    const auto refusal = [](const char* rows) {
        return test::message_of<UserError>(
            [&] { parse_reported(std::string("quantity,hits,n\n") + rows, "f.csv", StandardErrors::required); });
    };
    EXPECT_THAT(refusal("a,3,2\n"), HasSubstr("more hits than the 2 trials"));
    EXPECT_THAT(refusal("a,0.5,2\n"), HasSubstr("not a whole number"));
    EXPECT_THAT(refusal("a,1,2.5\n"), HasSubstr("not a whole number up to 2^53"));
    EXPECT_THAT(
        test::message_of<UserError>([] { parse_reported("quantity,hits\na,1\n", "f.csv", StandardErrors::required); }),
        HasSubstr("column 'n' is missing"));
}

TEST(PlanReported, SaysHowManyRunsAreNeeded) {
    Spec spec;
    const auto shares = plan_reported(spec, share_gate(0.3, 0.01), file_of_hits(20, 1, 1000, 0.3, 1), nullptr);
    EXPECT_EQ(shares.comparisons, 20u);
    EXPECT_EQ(shares.at_hand, 1u);
    int passed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        passed +=
            judged(share_gate(0.3, 0.01), file_of_hits(20, 1, 1000 * shares.needed, 0.3, seed)).verdict == Verdict::pass
                ? 1
                : 0;
    // Power 0.9: fewer than 77 of 100 are seen with a probability below 1e-4.
    EXPECT_GE(passed, 77);
    Gate means = reported_gate(GateKind::bias, {-5e-4, 5e-4});
    means.against = Against::number;
    means.reference = 1;
    const auto plan = plan_reported(spec, means, file_of_bins(100, 1, 1), nullptr);
    passed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        passed += judged(means, file_of_bins(100, plan.needed, seed)).verdict == Verdict::pass ? 1 : 0;
    EXPECT_GE(passed, 77);
}

Gate independent_gate(double band) {
    Gate gate = reported_gate(GateKind::bias, {-band, band});
    gate.against = Against::number;
    gate.reference = 1;
    gate.combine = Combination::chi_squared;
    return gate;
}

TEST(IndependentBins, FailTogetherWhenNoneFailsAlone) {
    // A shift of 1000 bins by 0.85 standard errors, with errors that are stated and with errors from ten runs.
    const auto result = judged(independent_gate(1e-9), file_of_bins(1000, 1, 3, 1, 0.85));
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_THAT(result.note, HasSubstr("takes the bins of file.csv for independent"));
    EXPECT_EQ(judged(independent_gate(1e-9), file_of_bins(1000, 10, 3, 1, 0.85 / std::sqrt(10.0))).verdict,
              Verdict::fail);
    EXPECT_EQ(judged(independent_gate(1e-9), file_of_bins(1000, 10, 3)).verdict, Verdict::inconclusive);
    EXPECT_EQ(judged(independent_gate(1e-2), file_of_bins(1000, 10, 3)).verdict, Verdict::pass);
}

TEST(IndependentBins, AreNotJudgedWhenCorrelated) {
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    std::string text = "quantity,bin,run,mean,standard_error\n";
    for (int run = 0; run < 12; ++run) {
        const double common = 0.7 * normal(engine);
        for (int bin = 0; bin < 300; ++bin)
            text += fmt::format("flux,{},{},{},{}\n", bin, run, 1 + reported_sigma * (common + 0.7 * normal(engine)),
                                reported_sigma);
    }
    const auto result = judged(independent_gate(1e-9), parse_reported(text, "file.csv", StandardErrors::required));
    EXPECT_EQ(result.verdict, Verdict::inconclusive);
    EXPECT_THAT(result.note, HasSubstr("vary together from run to run"));
}

}  // namespace
}  // namespace ff::studies::gates
