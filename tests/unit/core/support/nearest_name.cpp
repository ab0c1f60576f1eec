#include "core/support/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff {
namespace {

constexpr std::array<std::string_view, 5> samplers{"random", "random_mt", "stratified", "sobol", "halton"};

TEST(NearestName, CorrectsAnInsertedDeletedReplacedOrSwappedLetter) {
    EXPECT_EQ(nearest_name("sobbol", samplers), "sobol");
    EXPECT_EQ(nearest_name("sobl", samplers), "sobol");
    EXPECT_EQ(nearest_name("sobel", samplers), "sobol");
    EXPECT_EQ(nearest_name("soblo", samplers), "sobol");
    EXPECT_EQ(nearest_name("sbool", samplers), "sobol");
}

TEST(NearestName, PrefersTheCloserName) {
    EXPECT_EQ(nearest_name("random_m", samplers), "random_mt");
    EXPECT_EQ(nearest_name("randm", samplers), "random");
}

TEST(NearestName, TakesTheFirstOfEquallyCloseNames) {
    constexpr std::array<std::string_view, 2> names{"cat", "car"};
    EXPECT_EQ(nearest_name("caz", names), "cat");
}

TEST(NearestName, CountsASwapAsOneChange) {
    constexpr std::array<std::string_view, 1> names{"ab"};
    EXPECT_EQ(nearest_name("ba", names), "ab");
}

TEST(NearestName, IgnoresCase) {
    EXPECT_EQ(nearest_name("SOBOL", samplers), "sobol");
    EXPECT_EQ(nearest_name("HaLtom", samplers), "halton");
}

TEST(NearestName, IsEmptyWhereNothingIsNear) {
    EXPECT_EQ(nearest_name("latin_hypercube", samplers), "");
    EXPECT_EQ(nearest_name("x", samplers), "");
    EXPECT_EQ(nearest_name("", samplers), "");
    EXPECT_EQ(nearest_name("sobol", {}), "");
}

TEST(DidYouMean, IsASentenceWithATrailingSpaceOrEmpty) {
    EXPECT_EQ(did_you_mean("cub", std::array<std::string_view, 2>{"box", "cube"}), "Did you mean 'cube'? ");
    EXPECT_EQ(did_you_mean("qwertz", std::array<std::string_view, 2>{"box", "cube"}), "");
}

}  // namespace
}  // namespace ff
