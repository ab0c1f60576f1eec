#include "studies/form_factors/sampled_row.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ff::studies::form_factors {
namespace {

SampledRow row_of_two() {
    SampledRow row{7, {}, 100, 60, 1};
    PairEstimate estimate;
    estimate.method = ExchangeMethod::points;
    estimate.level = 0.955;
    estimate.samples = 40;
    estimate.contradicted = true;
    estimate.other = {0.1, 0.01, 0.02, 0.005};
    estimate.sum =
        SampledSum{0.5, {{-1, {{0.1, 0.2}, 32, {0.9, 0.1, 2}, false, 0}}, {2, {{0.5}, 8, {}, true, 4}}}, 1e-9};
    row.estimates = {{3, estimate}, {90000, {}}};
    return row;
}

TEST(SampledRow, SurvivesARoundTripThroughWords) {
    const SampledRow row = row_of_two();
    const auto words = to_words(row);
    const auto read = sampled_row(words);
    ASSERT_TRUE(read);
    EXPECT_EQ(to_words(*read), words);
    EXPECT_EQ(read->row, 7u);
    EXPECT_EQ(read->samples, 100u);
    ASSERT_EQ(read->estimates.size(), 2u);
    const PairEstimate& estimate = read->estimates[0].second;
    EXPECT_TRUE(estimate.method == ExchangeMethod::points && estimate.contradicted);
    EXPECT_EQ(estimate.other.up, 0.02);
    ASSERT_TRUE(estimate.sum);
    EXPECT_EQ(estimate.sum->terms[0].share.means, (std::vector{0.1, 0.2}));
    EXPECT_EQ(estimate.sum->terms[0].share.unmet.power, 2);
    EXPECT_EQ(estimate.sum->terms[1].share.met, 4u);
    EXPECT_EQ(read->estimates[1].first, 90000u);
    EXPECT_FALSE(read->estimates[1].second.sum);
}

TEST(SampledRow, IsEmptyForTooFewTooManyOrRandomWords) {
    const auto words = to_words(row_of_two());
    for (std::size_t size = 0; size < words.size(); ++size)
        EXPECT_FALSE(sampled_row(std::span(words).first(size))) << size;
    auto longer = words;
    longer.push_back(0);
    EXPECT_FALSE(sampled_row(longer));
    std::mt19937_64 random(1);
    for (int k = 0; k < 1000; ++k) {
        std::vector<std::uint64_t> noise(words.size());
        std::generate(noise.begin(), noise.end(), std::ref(random));
        EXPECT_FALSE(sampled_row(noise));
    }
}

}  // namespace
}  // namespace ff::studies::form_factors
