#include "studies/diagnostics/variances.hpp"

#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

using test::plan_of;
using test::study_text;

StudyPlan plan_of_rays(std::string_view sampler, std::string_view completion = "direct", int samples = 64) {
    return plan_of(study_text("trials = 400", fmt::format("[[method]]\nname = \"SR\"\nsampler = \"{}\"\n"
                                                          "estimator = \"ray_shooting\"\npatches_per_face = 4\n"
                                                          "samples_per_patch = {}\ncompletion = \"{}\"",
                                                          sampler, samples, completion)));
}

/// The effect that a chi-squared test of 30 pairs at 1e-6 (Holm) notices with 400 trials: a standard deviation that is
/// wrong by a factor of about 1 + (5.5 + 2) / sqrt(2 * 400) = 1.27, power 0.98.
constexpr double alarm_level = 1e-6;

std::optional<VarianceCheck> only_check(const Analysis& findings) {
    auto checks = check_variances(findings);
    return checks.empty() ? std::nullopt : std::optional(std::move(checks.front()));
}

TEST(VarianceCheck, AgreesForIndependentRays) {
    for (const char* completion : {"direct", "reciprocal"}) {
        const Analysis findings = analyse(test::run(plan_of_rays("random", completion)));
        const auto check = only_check(findings);
        ASSERT_TRUE(check);
        EXPECT_GT(check->adjusted_p, alarm_level);
        EXPECT_GT(check->smallest_ratio, 0.8);
        EXPECT_LT(check->largest_ratio, 1.25);
        // Direct sums are always 1; of the reciprocal ones the first.
        EXPECT_EQ(check->quantities.size(), std::string_view(completion) == "direct" ? 30u : 15u + 5);
    }
}

TEST(VarianceCheck, CatchesAWrongNumberOfRays) {
    Analysis findings = analyse(test::run(plan_of_rays("random")));
    for (const std::uint64_t claimed : {32u, 128u}) {  // true: 64; standard deviations wrong by sqrt(2)
        findings.plan.cells[0].samples_per_patch = claimed;
        const auto check = only_check(findings);
        ASSERT_TRUE(check);
        EXPECT_LT(check->adjusted_p, alarm_level);
    }
}

TEST(VarianceCheck, CatchesDependentRays) {
    // The same store under the name of a sampler with independent points.
    Analysis findings = analyse(test::run(plan_of_rays("sobol")));
    EXPECT_FALSE(only_check(findings));
    findings.plan.spec.methods[0].sampler = "random";
    EXPECT_LT(only_check(findings)->adjusted_p, alarm_level);
}

TEST(VarianceCheck, ExpectsTheStratifiedVarianceOfRaysFromPatches) {
    // Not the binomial F (1 - F) / N: patches beside an edge send more rays to the face beyond it. The four patches of
    // a face see the opposite one alike, so that nothing is gained there.
    const Analysis findings = analyse(test::run(plan_of_rays("random")));
    const auto check = only_check(findings);
    ASSERT_TRUE(check);
    for (const VarianceComparison& c : check->quantities) {
        const Summary& summary = findings.cells[0].summary(c.quantity);
        const double binomial = std::sqrt(*summary.reference * (1 - *summary.reference) / 256);
        const double least = summary.pair_class == PairClass::parallel ? 1 - 1e-12 : 0.9;
        const double most = summary.pair_class == PairClass::parallel ? 1 + 1e-12 : 0.99;
        EXPECT_GT(c.exact, least * binomial);
        EXPECT_LT(c.exact, most * binomial);
    }
}

TEST(VarianceCheck, SkipsOtherEstimators) {
    const auto plan = plan_of(study_text("trials = 4",
                                         "[[method]]\nname = \"k\"\nsampler = \"random\"\n"
                                         "estimator = \"area_kernel\"\nsamples_per_patch = 10"));
    EXPECT_FALSE(only_check(analyse(test::run(plan))));
}

TEST(VarianceCheck, SharesOneErrorRateAmongTheCellsOfAStudy) {
    const Analysis one = analyse(test::run(plan_of_rays("random")));
    Analysis three = one;
    for (std::size_t cell = 1; cell < 3; ++cell) {
        three.cells.push_back(one.cells[0]);
        three.plan.cells.push_back(one.plan.cells[0]);
        three.cells.back().cell = cell;
    }
    const double alone = only_check(one)->adjusted_p;
    const auto together = check_variances(three);
    ASSERT_EQ(together.size(), 3u);
    for (const VarianceCheck& check : together) EXPECT_NEAR(check.adjusted_p, 1 - std::pow(1 - alone, 3), 1e-12);
}

}  // namespace
}  // namespace ff::studies
