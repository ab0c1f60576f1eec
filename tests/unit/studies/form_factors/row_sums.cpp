#include "studies/form_factors/matrix_builder.hpp"

#include "stats/basics/resampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ff::studies::form_factors {
namespace {

std::vector<PairEstimate> random_estimates(std::size_t count) {
    stats::Draws draws(derive_key(Seed{1}, "row sums"), stats::Resampling::simulation, 0);
    std::vector<PairEstimate> result(count);
    for (PairEstimate& estimate : result) {
        SampledSum sum;
        sum.offset = draws.uniform() * 1e-3;
        sum.offset_error = draws.uniform() * 1e-9;
        SampledShare share;
        for (std::size_t r = 0; r < randomisations; ++r) share.means.push_back(draws.uniform() - 0.5);
        share.points = 1024;
        share.unmet = {.rough = draws.uniform()};
        sum.terms.push_back({draws.uniform() * 1e-4, share});
        estimate.sum = sum;
    }
    return result;
}

TEST(RowSums, AddUpAllTerms) {
    const double area = 0.37;
    SampledSum all;
    RowSums sums({1.0, area}, {0.9, 0.99});
    for (const PairEstimate& estimate : random_estimates(200)) {
        sums.add(1, estimate);
        all.offset += estimate.sum->offset;
        all.offset_error += estimate.sum->offset_error;
        all.terms.insert(all.terms.end(), estimate.sum->terms.begin(), estimate.sum->terms.end());
    }
    for (const double level : {0.9, 0.99}) {
        const EstimatedSum expected = estimate_of(all, level);
        const EstimatedSum found = sums.at(1, level);
        EXPECT_NEAR(found.value, expected.value / area, 1e-14);
        EXPECT_NEAR(found.up, expected.up / area, 1e-14);
        EXPECT_NEAR(found.down, expected.down / area, 1e-14);
    }
    EXPECT_EQ(sums.at(0, 0.9).value, 0) << "nothing was added to it";
    EXPECT_EQ(sums.at(0, 0.9).up, 0);
}

TEST(RowSums, DoNotDependOnTheOrder) {
    const std::vector<PairEstimate> pairs = random_estimates(200);
    RowSums sums({0.37}, {0.95});
    RowSums reversed({0.37}, {0.95});
    std::for_each(pairs.begin(), pairs.end(), [&](const PairEstimate& estimate) { sums.add(0, estimate); });
    std::for_each(pairs.rbegin(), pairs.rend(), [&](const PairEstimate& estimate) { reversed.add(0, estimate); });
    EXPECT_EQ(sums.at(0, 0.95).value, reversed.at(0, 0.95).value);
    EXPECT_EQ(sums.at(0, 0.95).up, reversed.at(0, 0.95).up);
}

}  // namespace
}  // namespace ff::studies::form_factors
