#include "core/estimators/added.hpp"
#include "core/exact/exact.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/comparison/run_comparison.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <string>

namespace ff::studies {
namespace {

TEST(RepeatedTrials, LeaveNothingToTestOrCompare) {
    add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{"few_seeds", "", ""}, program_traits(false, true),
                                         nullptr, nullptr));
    const StudyPlan plan =
        test::plan_of(test::study_text("trials = 100", "[[method]]\nname = \"mine\"\nestimator = \"few_seeds\"\n"));
    const auto exact = exact_form_factors(plan.scenes.front()).value();
    const auto run_with = [&](std::uint64_t seeds) {
        return test::fill(plan, [&exact, seeds](std::size_t cell, std::uint64_t trial, int from, int to) {
            std::mt19937_64 bits(1000 * (trial % seeds) + 100 * cell + static_cast<std::uint64_t>(10 * from + to));
            return exact(from - 1, to - 1) + std::normal_distribution<double>(0, 1e-3)(bits);
        });
    };
    const auto findings_of = [&](std::uint64_t seeds) { return analyse(run_with(seeds)); };
    for (const std::uint64_t seeds : {2u, 3u, 4u}) {
        EXPECT_EQ(findings_of(seeds).cells.at(0).repeated_trials, 100 - seeds);
        EXPECT_EQ(findings_of(seeds).cells.at(0).bias_finding, BiasFinding::untestable);
    }
    const Analysis found = findings_of(8);
    const CellAnalysis& cell = found.cells.at(0);
    EXPECT_EQ(cell.repeated_trials, 92u);
    EXPECT_EQ(cell.bias_finding, BiasFinding::untestable);
    EXPECT_FALSE(cell.summary({QuantityKind::form_factor, 1, 2}).bias_interval);
    EXPECT_FALSE(cell.class_error(PairClass::parallel)->mean_square);  // so that no contest takes it
    EXPECT_NE(fmt::format("{}", fmt::join(found.plan.warnings, "|")).find("92 of 100 trials repeat earlier ones"),
              std::string::npos);

    const Analysis sound = findings_of(100);
    EXPECT_EQ(sound.cells.at(0).repeated_trials, 0u);
    EXPECT_NE(sound.cells.at(0).bias_finding, BiasFinding::untestable);
    EXPECT_TRUE(sound.plan.warnings.empty());

    const RunComparison compared = compare_runs(run_with(8), run_with(99), {"few", "many"});
    EXPECT_EQ(compared.tests, 0u);
}

}  // namespace
}  // namespace ff::studies
