#include "studies/diagnostics/variances.hpp"

#include "core/exact/exact.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ff::studies {
namespace {

StudyPlan heavy_tail_plan() {
    return test::plan_of(test::study_text("trials = 2000", R"([[method]]
name = "a"
sampler = "random"
estimator = "point_to_polygon"
samples_per_patch = 16
)"));
}

/// Pareto values of this tail index for F 1-6, normal ones for all other pairs.
std::vector<HeavyTail> found_for(double index) {
    const StudyPlan study = heavy_tail_plan();
    const Store store = test::fill(study, [=](std::size_t, std::uint64_t trial, int from, int to) {
        std::seed_seq seed{static_cast<int>(trial), from, to};
        std::mt19937_64 engine(seed);
        if (from != 1 || to != 6) return 0.2 + 0.01 * std::normal_distribution<double>()(engine);
        return 0.1 * std::pow(1 - std::uniform_real_distribution<double>(0, 0.999999)(engine), -1 / index);
    });
    return find_heavy_tails(store, analyse(store));
}

TEST(HeavyTails, AreFoundForInfiniteVariance) {
    const auto found = found_for(1.2);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().pair, (Quantity{QuantityKind::form_factor, 1, 6}));
    EXPECT_LT(found.front().index, 2);
}

TEST(HeavyTails, AreNotFoundForFiniteVariance) {
    EXPECT_TRUE(found_for(6).empty());
}

}  // namespace
}  // namespace ff::studies
