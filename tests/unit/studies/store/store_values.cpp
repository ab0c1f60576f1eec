#include "studies/store/store.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

using test::in_memory;

StudyPlan plan_of_random_rays() {
    return test::plan_of(test::study_text("trials = 3", test::random_rays));
}

TEST(StoreValues, AreKeptToTheBit) {
    Store store = Store::create_or_resume(in_memory, plan_of_random_rays());
    const double third = 1.0 / 3;
    store.commit({0, {{observable::estimate, 1, 2, 0, third}, {observable::estimate, 1, 2, 1, 5e-324}}, {}, {}});
    EXPECT_THAT(store.series(0, observable::estimate, 1, 2).value, testing::ElementsAre(third, 5e-324));
}

TEST(StoreValues, AreKeptEvenIfNotFinite) {
    Store store = Store::create_or_resume(in_memory, plan_of_random_rays());
    const double infinity = std::numeric_limits<double>::infinity();
    store.commit({0,
                  {{observable::estimate, 1, 2, 0, -infinity},
                   {observable::estimate, 1, 2, 1, std::numeric_limits<double>::quiet_NaN()},
                   {observable::estimate, 1, 2, 2, infinity}},
                  {},
                  {}});
    const auto values = store.series(0, observable::estimate, 1, 2).value;
    ASSERT_EQ(values.size(), 3u);
    EXPECT_EQ(values[0], -infinity);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_EQ(values[2], infinity);
}

TEST(StoreValues, AreReadByTrialAndAsTotalsOverTrials) {
    Store store = Store::create_or_resume(in_memory, plan_of_random_rays());
    store.commit({0,
                  {{observable::hits, 1, 2, 2, std::int64_t{5}},
                   {observable::hits, 1, 2, 0, std::int64_t{3}},
                   {observable::hits, 2, 1, 0, std::int64_t{100}},
                   {observable::lost, 1, 0, 0, std::int64_t{100}}},
                  {},
                  {}});
    const auto series = store.series(0, observable::hits, 1, 2);
    EXPECT_THAT(series.trial, testing::ElementsAre(0, 2));
    EXPECT_THAT(series.value, testing::ElementsAre(3, 5));
    EXPECT_EQ(store.total(0, observable::hits, 1, 2), 8);
    EXPECT_EQ(store.total(0, observable::hits, 3, 4), 0);
}

}  // namespace
}  // namespace ff::studies
