#include "core/support/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff {
namespace {

constexpr std::array<std::string_view, 5> sampler_names{"random", "random_mt", "stratified", "sobol", "halton"};

TEST(NearestName, CorrectsAnInsertedDeletedReplacedOrSwappedLetter) {
    EXPECT_EQ(nearest_name("sobbol", sampler_names), "sobol");
    EXPECT_EQ(nearest_name("sobl", sampler_names), "sobol");
    EXPECT_EQ(nearest_name("sobel", sampler_names), "sobol");
    EXPECT_EQ(nearest_name("soblo", sampler_names), "sobol");
    EXPECT_EQ(nearest_name("sbool", sampler_names), "sobol");
}

TEST(NearestName, PrefersTheCloserName) {
    EXPECT_EQ(nearest_name("random_m", sampler_names), "random_mt");
    EXPECT_EQ(nearest_name("randm", sampler_names), "random");
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
    EXPECT_EQ(nearest_name("SOBOL", sampler_names), "sobol");
    EXPECT_EQ(nearest_name("HaLtom", sampler_names), "halton");
}

TEST(NearestName, IsEmptyWhereNothingIsNear) {
    EXPECT_EQ(nearest_name("latin_hypercube", sampler_names), "");
    EXPECT_EQ(nearest_name("x", sampler_names), "");
    EXPECT_EQ(nearest_name("", sampler_names), "");
    EXPECT_EQ(nearest_name("sobol", {}), "");
}

TEST(DidYouMean, IsASentenceWithATrailingSpaceOrEmpty) {
    EXPECT_EQ(did_you_mean("cub", std::array<std::string_view, 2>{"box", "cube"}), "Did you mean 'cube'? ");
    EXPECT_EQ(did_you_mean("qwertz", std::array<std::string_view, 2>{"box", "cube"}), "");
}

}  // namespace
}  // namespace ff
