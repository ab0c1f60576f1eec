#include "studies/store/records.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

TEST(RecordWords, RestoreTheRecord) {
    UnitRecord record;
    record.unit = 7;
    record.observations = {{observable::hits, 1, 2, 3, std::int64_t{-4}},
                           {observable::rays, 6, 0, std::numeric_limits<std::uint64_t>::max(), std::int64_t{1} << 62},
                           {observable::lost, 2, 0, 0, std::int64_t{0}},
                           {observable::estimate, 1, 6, 5, 1.0 / 3},
                           {observable::estimate, 1, 5, 5, -0.0},
                           {observable::estimate, 1, 4, 5, std::numeric_limits<double>::infinity()}};
    record.patch_hits = {1, 2, 3};
    record.patch_hits_squared = {1, 4};
    const UnitRecord again = from_words(to_words(record));
    EXPECT_EQ(again.unit, record.unit);
    EXPECT_EQ(again.patch_hits, record.patch_hits);
    EXPECT_EQ(again.patch_hits_squared, record.patch_hits_squared);
    ASSERT_EQ(again.observations.size(), record.observations.size());
    for (std::size_t i = 0; i < record.observations.size(); ++i) {
        EXPECT_EQ(again.observations[i].observable, record.observations[i].observable);
        EXPECT_EQ(again.observations[i].from_face, record.observations[i].from_face);
        EXPECT_EQ(again.observations[i].to_face, record.observations[i].to_face);
        EXPECT_EQ(again.observations[i].trial, record.observations[i].trial);
        EXPECT_EQ(again.observations[i].value, record.observations[i].value);
    }
    EXPECT_TRUE(std::signbit(std::get<double>(again.observations[4].value)));
}

TEST(RecordWords, HoldOnlyTheHeadOfAnEmptyRecord) {
    EXPECT_EQ(to_words({}).size(), 4u);
    EXPECT_TRUE(from_words(to_words({})).observations.empty());
}

}  // namespace
}  // namespace ff::studies
