#include "studies/spec/sample_sizes.hpp"

#include "core/support/error.hpp"
#include "studies/spec/spec.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace ff::studies {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::uint64_t> sizes(std::string_view text, std::string_view sampler = "sobol") {
    return read_sample_sizes(text, samplers::find(sampler).info, 4);
}

std::string refusal_of_sizes(std::string_view text, std::string_view sampler = "sobol") {
    return test::message_of<UserError>([&] { static_cast<void>(sizes(text, sampler)); });
}

TEST(SampleSizes, MayBeNumbersPowersOrLists) {
    EXPECT_THAT(sizes("1000"), ElementsAre(1000));
    EXPECT_THAT(sizes("5^4, 2^10,7"), ElementsAre(625, 1024, 7));
}

TEST(SampleSizes, SuitTheSamplerWithinARange) {
    EXPECT_THAT(sizes("2^6..2^8"), ElementsAre(64, 128, 256));
    EXPECT_THAT(sizes("64 .. 3200", "faure"), ElementsAre(125, 625, 3125));
    EXPECT_THAT(sizes("2^6..2^8", "stratified"), ElementsAre(81, 256));
    EXPECT_THAT(sizes("2^6..2^7, 100, 64"), ElementsAre(64, 128, 100));
}

TEST(SampleSizes, AreRefusedWithTheReason) {
    EXPECT_THAT(refusal_of_sizes("many"), HasSubstr("'many' is not a number of points"));
    EXPECT_THAT(refusal_of_sizes(""), HasSubstr("'' is not a number of points"));
    EXPECT_THAT(refusal_of_sizes("2^x"), HasSubstr("'2^x' is not a number of points"));
    EXPECT_THAT(refusal_of_sizes("-4..8"), HasSubstr("'-4' is not a number of points"));
    for (const std::string_view text : {"0", "0^3", "2^33", "1e9^1", "3^99999999999", "99999999999999999999"}) {
        EXPECT_NE(refusal_of_sizes(text), "nothing thrown") << text;
    }
    EXPECT_THAT(refusal_of_sizes("2^8..2^6"), HasSubstr("ends before it begins"));
    EXPECT_THAT(refusal_of_sizes("130..600", "faure"), HasSubstr("no size that faure is made for"));
}

TEST(SampleSizes, MayBeARangeInAStudyFile) {
    const auto spec = parse_study(test::study_text("trials = 2", R"([[method]]
name = "faure"
sampler = "faure"
estimator = "ray_shooting"
samples_per_patch = "2^6..2^16"
)"),
                                  "study.toml");
    std::vector<std::uint64_t> taken;
    for (const Size& size : spec.methods.front().sizes) taken.push_back(*size.samples_per_patch);
    EXPECT_THAT(taken, ElementsAre(125, 625, 3125, 15'625));
    EXPECT_EQ(parse_study(to_toml(spec), "again"), spec);
}

TEST(SampleSizes, AreRefusedAtTheirPlaceInAStudyFile) {
    try {
        static_cast<void>(parse_study(test::study_text("trials = 2", R"([[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = "2^6..2^"
)"),
                                      "study.toml"));
        FAIL() << "accepted";
    } catch (const UserError& error) {
        EXPECT_THAT(error.what(), HasSubstr("study.toml:10:21: samples_per_patch = '2^6..2^' ('2^' is not a number"));
    }
}

}  // namespace
}  // namespace ff::studies
