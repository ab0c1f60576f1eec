#include "studies/comparison/duel.hpp"

#include "tests/unit/studies/comparison/two_methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ff::studies {
namespace {

/// The most informative bout on parallel pairs of two methods, by their indices in two runs.
std::optional<Bout> main_bout(const Store& first, std::size_t method, const Store& second, std::size_t other,
                              Equal equal) {
    const Analysis a = analyse(first);
    const Analysis b = analyse(second);
    const auto bouts = hold_duel({first, a, method}, {second, b, other}, {{0, 0}});
    const auto found = std::ranges::find_if(bouts, [&](const Bout& bout) {
        return bout.is_main && bout.equal == equal && bout.pair_class == PairClass::parallel;
    });
    return found == bouts.end() ? std::nullopt : std::optional(*found);
}

// With 10000 rays A has an error of 0.004; B has 0.08 with 100, and 0.008 in the mean of 100 runs.
TEST(Duel, ComparesUnlikeSizesOfTwoRunsAtEqualEvaluations) {
    const Store first = test::store_with_errors({0.04, 0.002, 0.02});
    const Store second = test::store_with_errors({0.02, 0.001, 0.04});
    const auto bout = main_bout(first, 0, second, 1, Equal::evaluations);
    ASSERT_TRUE(bout);
    EXPECT_EQ(bout->budget, 60000);
    EXPECT_EQ(bout->better, 0u);
    EXPECT_NEAR(bout->ratio, 4, 0.01);
    EXPECT_TRUE(bout->is_shown);
    EXPECT_EQ(bout->cells, (std::array<std::size_t, 2>{1, 2}));
    // The other way round, it is the second that is better.
    const auto turned = main_bout(second, 1, first, 0, Equal::evaluations);
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned->better, 1u);
    EXPECT_DOUBLE_EQ(turned->ratio, bout->ratio);
    // Nobody measured their time.
    EXPECT_FALSE(main_bout(first, 0, second, 1, Equal::processor_time));
}

TEST(Duel, ShowsNothingBetweenEqualErrors) {
    const Store first = test::store_with_errors({0.04, 0.002, 0.02});
    const Store second = test::store_with_errors({0.04, 0.002, 0.02});
    const auto bout = main_bout(first, 0, second, 1, Equal::evaluations);
    ASSERT_TRUE(bout);
    EXPECT_FALSE(bout->is_shown);
}

TEST(Duel, PutsTheMethodFirstThatIsExact) {
    constexpr const char* methods = R"([[method]]
name = "exact"
estimator = "adaptive_contour"
samples_per_patch = 300
[[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [16, 256]
)";
    const Store store = test::run(test::plan_of(test::study_text("trials = 20", methods)));
    const auto bout = main_bout(store, 1, store, 0, Equal::evaluations);
    ASSERT_TRUE(bout);
    EXPECT_TRUE(bout->is_exact && bout->is_shown);
    EXPECT_EQ(bout->better, 1u);
}

}  // namespace
}  // namespace ff::studies
