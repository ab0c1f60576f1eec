#include "studies/verdicts/reported/distribution_gates.hpp"

#include "core/support/error.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "studies/verdicts/reported/reported_gates.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

Gate distribution_gate(double band) {
    Gate gate;
    gate.name = "g";
    gate.quantity = "x";
    gate.kind = GateKind::distribution;
    gate.band = {0, band};
    gate.place = "bands.toml:5:8";
    gate.against = Against::file;
    return gate;
}

Spec spec_of(const Gate& gate) {
    Spec spec;
    spec.gates = {gate};
    return spec;
}

ReportedFile counts(const std::string& rows, std::string_view column = "count") {
    return parse_reported(fmt::format("quantity,bin,{}\n{}", column, rows), "file.csv", StandardErrors::optional);
}

std::string refusal_to_judge(const Gate& gate, const ReportedFile& file, const ReportedFile* against) {
    return test::message_of<UserError>([&] { static_cast<void>(judge_reported(spec_of(gate), gate, file, against)); });
}

TEST(DistributionGates, JudgeCountsToPassFailOrBeTooFew) {
    const auto shares = counts("x,0,0.5\nx,1,0.5\n", "share");
    const auto judged = [&](const std::string& rows) {
        const Gate gate = distribution_gate(0.1);
        return judge_reported(spec_of(gate), gate, counts(rows), &shares);
    };
    EXPECT_EQ(judged("x,0,5010\nx,1,4990\n").verdict, Verdict::pass);
    EXPECT_EQ(judged("x,0,6000\nx,1,4000\n").verdict, Verdict::fail);
    EXPECT_EQ(judged("x,0,51\nx,1,49\n").verdict, Verdict::inconclusive);
    EXPECT_THAT(judged("x,0,3\nx,1,4\n").note, HasSubstr("fewer than two cells"));
    EXPECT_THAT(judged("x,0,6000\nx,1,4000\n").note, HasSubstr("worst"));
}

TEST(DistributionGates, FailOnACountWhereTheShareIsZero) {
    const auto shares = counts("x,0,0.5\nx,1,0.5\nx,2,0\n", "share");
    const Gate gate = distribution_gate(0.5);
    const auto result = judge_reported(spec_of(gate), gate, counts("x,0,500\nx,1,500\nx,2,1\n"), &shares);
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_THAT(result.note, HasSubstr("share is 0"));
}

TEST(DistributionGates, FailOnACountThatNoDistributionInTheBandExplains) {
    const auto shares = counts("x,0,1e-300\nx,1,0.5\nx,2,0.5\n", "share");
    const auto file = counts("x,0,1\nx,1,100\nx,2,90\n");
    const Gate narrow = distribution_gate(1e-3);
    const auto failed = judge_reported(spec_of(narrow), narrow, file, &shares);
    EXPECT_EQ(failed.verdict, Verdict::fail);
    EXPECT_THAT(failed.note, HasSubstr("bin 0 has a count of 1 where 1.91e-298 are expected"));
    const Gate wide = distribution_gate(0.5);
    const auto passed = judge_reported(spec_of(wide), wide, file, &shares);
    EXPECT_EQ(passed.verdict, Verdict::pass);
    EXPECT_THAT(passed.note, HasSubstr("worst 2 (-0.796 errors), 1 (+0.651 errors); takes"));
}

TEST(DistributionGates, JudgeHugeCounts) {
    const auto shares = counts("x,0,0.4\nx,1,0.3\nx,2,0.3\n", "share");
    const Gate gate = distribution_gate(0.05);
    const auto judged = [&](const std::string& rows) {
        return judge_reported(spec_of(gate), gate, counts(rows), &shares).verdict;
    };
    EXPECT_EQ(judged("x,0,3602879701896396\nx,1,2702159776422297\nx,2,2702159776422297\n"), Verdict::pass);
    EXPECT_EQ(judged("x,0,9007199254740992\nx,1,0\nx,2,0\n"), Verdict::fail);
}

TEST(DistributionGates, RefuseFilesThatCannotBeCompared) {
    const auto file = counts("x,0,500\nx,1,510\n");
    const auto short_of_one = counts("x,0,0.5\nx,1,0.4\n", "share");
    const auto none = counts("x,0,0\nx,1,0\n");
    EXPECT_THAT(refusal_to_judge(distribution_gate(0.1), file, &short_of_one), HasSubstr("add up to 0.9"));
    EXPECT_THAT(refusal_to_judge(distribution_gate(0.1), none, &file), HasSubstr("nothing would be compared"));
    EXPECT_THAT(refusal_to_judge(distribution_gate(0.1), short_of_one, &file), HasSubstr("holds shares"));
    EXPECT_THAT(refusal_to_judge(distribution_gate(0.1), file, nullptr), HasSubstr("--against"));
    const auto means = parse_reported("quantity,mean,standard_error\nx,1,0.1\n", "means.csv", StandardErrors::required);
    EXPECT_THAT(refusal_to_judge(distribution_gate(0.1), means, &file), HasSubstr("is not for means.csv"));
    Gate equal = distribution_gate(0.1);
    equal.kind = GateKind::equal;
    EXPECT_THAT(refusal_to_judge(equal, file, &file), HasSubstr("\"equal\" is not for"));
    EXPECT_THROW(counts("x,0,1.5\nx,1,2\n"), UserError);  // weighted
    EXPECT_THROW(counts("x,0,-1\nx,1,2\n"), UserError);
    EXPECT_THROW(counts("x,0,1\nx,0,2\n"), UserError);  // twice
}

EstimatesFile normal_file(std::size_t n, std::uint64_t seed, double shift = 0) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(shift, 1);
    std::string text = "trial,quantity,estimate\n";
    for (std::size_t i = 0; i < n; ++i) text += fmt::format("{},x,{}\n", i, normal(engine));
    return parse_estimates(text, "trials.csv");
}

// Seeds 1 to 5; alpha 1e-4, passes with power 0.9: 4000 values are more than values_for_distance asks for.
TEST(DistributionGates, JudgeValuesToPassFailOrBeTooFew) {
    Gate gate = distribution_gate(0.06);
    gate.law = KnownLaw{KnownLaw::Family::normal, 0, 1};
    const auto judged = [&](const EstimatesFile& file) { return judge_estimates(spec_of(gate), gate, file).verdict; };
    EXPECT_LE(values_for_distance(0.06, {}, 1), 4000u);
    EXPECT_EQ(judged(normal_file(4000, 1)), Verdict::pass);
    EXPECT_EQ(judged(normal_file(500, 2, 0.8)), Verdict::fail);
    EXPECT_EQ(judged(normal_file(50, 3)), Verdict::inconclusive);
    gate.law.reset();
    const auto old = normal_file(500, 4);
    const auto shifted = normal_file(500, 5, 1);
    EXPECT_EQ(judge_estimates(spec_of(gate), gate, shifted, &old).verdict, Verdict::fail);
    EXPECT_THROW(judge_estimates(spec_of(gate), gate, old, &old), UserError);
}

TEST(KnownLaw, RefusesMissingParameters) {
    std::string problem;
    EXPECT_FALSE(parse_law("normal", problem));
    EXPECT_THAT(problem, HasSubstr("fitted to the values"));
    EXPECT_FALSE(parse_law("normal(0)", problem));
    EXPECT_FALSE(parse_law("normal(0, x)", problem));
    EXPECT_FALSE(parse_law("uniform(1, 1)", problem));
    EXPECT_THAT(problem, HasSubstr("without width"));
    EXPECT_FALSE(parse_law("gaussian(0, 1)", problem));
    EXPECT_THAT(problem, HasSubstr("normal(0, 1)"));
}

TEST(KnownLaw, HasTheStatedDistribution) {
    std::string problem;
    EXPECT_DOUBLE_EQ(cumulative(*parse_law("uniform(2, 4)", problem), 3), 0.5);
    EXPECT_DOUBLE_EQ(cumulative(*parse_law("normal( 1 ,2 )", problem), 1), 0.5);
    EXPECT_NEAR(cumulative(*parse_law("exponential(2)", problem), 2), 1 - std::exp(-1), 1e-15);
    EXPECT_EQ(cumulative(*parse_law("exponential(2)", problem), -1), 0);
}

}  // namespace
}  // namespace ff::studies::gates
