#include "studies/sampler_checks/promises.hpp"

#include "core/support/error.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "tests/unit/studies/sampler_checks/made_samplers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::optional<std::string> broken(std::string_view promise, const samplers::PointSet& set, std::uint32_t base = 2) {
    return broken_by(parse_promise(promise), set, 0, base);
}

TEST(Promises, AreReadAndNamed) {
    for (const char* const text : {"latin", "net:0", "net:12", "stratified", "lattice"})
        EXPECT_EQ(name_of(parse_promise(text)), text);
    for (const char* const text : {"", "net", "net:", "net:x", "net:-1", "net:2x", "Latin", "net:99999999999"})
        EXPECT_THROW(parse_promise(text), UserError) << text;
}

TEST(Promises, SayWhichSizesCannotKeepThem) {
    EXPECT_EQ(why_impossible(parse_promise("stratified"), 64, 4, 2), "64 points are no k^4 cells");
    EXPECT_EQ(why_impossible(parse_promise("stratified"), 64, 3, 2), "");
    EXPECT_EQ(why_impossible(parse_promise("net:1"), 100, 2, 2), "100 points are no power of 2");
    EXPECT_EQ(why_impossible(parse_promise("net:7"), 64, 2, 2), "t is at most 6");
    EXPECT_EQ(why_impossible(parse_promise("latin"), 100, 2, 2), "");
}

TEST(Promises, NameThePlaceWhereOneIsBroken) {
    const auto set = test::set_of({{0.1, 0.1}, {0.3, 0.8}, {0.6, 0.3}, {0.9, 0.9}});
    EXPECT_EQ(broken("latin", set), "coordinate 1: slice 3 of 4 has 2 points");
    EXPECT_EQ(broken("stratified", set), std::nullopt);
    EXPECT_EQ(broken("net:0", set), "part 3 of 4 of coordinate 1: 2 points, not 1");
    EXPECT_EQ(broken("net:1", set), std::nullopt);
    EXPECT_EQ(broken("lattice", set), "point 1: no lattice of 4 points has it and those before it");
    const auto crowded = test::set_of({{0.1, 0.6}, {0.3, 0.8}, {0.6, 0.3}, {0.9, 0.9}});
    EXPECT_EQ(broken("stratified", crowded), "cell (0, 1) of 2^2 has 2 points");
}

TEST(Promises, HoldForSamplersThatMakeThem) {
    const auto drawn = [](std::string_view name, std::uint64_t n, std::size_t d) {
        return samplers::draw_set(samplers::find(name), {n, d});
    };
    EXPECT_EQ(broken("latin", drawn("latin_hypercube", 100, 4)), std::nullopt);
    EXPECT_EQ(broken("latin", drawn("hammersley", 100, 1)), std::nullopt);
    EXPECT_EQ(broken("stratified", drawn("stratified", 625, 4)), std::nullopt);
    EXPECT_EQ(broken("net:0", drawn("faure", 625, 4), 5), std::nullopt);
    EXPECT_EQ(broken("net:3", drawn("sobol", 256, 4)), std::nullopt);
    EXPECT_EQ(broken("lattice", drawn("lattice", 256, 4)), std::nullopt);
    for (const char* const promise : {"latin", "stratified", "net:3", "lattice"})
        EXPECT_TRUE(broken(promise, drawn("random", 256, 4))) << promise;
}

// Some of this many points lie within 2^-32 of a boundary of their slice, on either side of it.
TEST(Promises, HoldForPointsThatChancePutsOnABoundary) {
    SamplerCheckRequest request{.points = 59049, .dimension = max_dimension, .trials = 8};
    request.promises = {parse_promise("latin")};
    const auto checks = check_sampler(samplers::find("latin_hypercube"), request);
    EXPECT_THAT(test::found(checks, SamplerVerdict::pass, "promise: latin"), SizeIs(1));
    request.promises = {};
    EXPECT_THAT(test::found(check_sampler(samplers::find("latin_hypercube"), request), SamplerVerdict::inconclusive,
                            "nearly a Latin hypercube"),
                IsEmpty());
}

// i / 3^m and its radical inverse lie on boundaries all of them.
TEST(Promises, HoldForPointsThatARulePutsOnBoundaries) {
    for (const std::size_t n : {27u, 243u}) {
        test::Rows rows(n, std::vector<double>(2));
        for (std::size_t i = 0; i < n; ++i) {
            rows[i][0] = static_cast<double>(i) / static_cast<double>(n);
            std::size_t inverse = 0;
            for (std::size_t scale = 1, left = i; scale < n; scale *= 3, left /= 3) inverse = 3 * inverse + left % 3;
            rows[i][1] = static_cast<double>(inverse) / static_cast<double>(n);
        }
        for (const char* const promise : {"latin", "net:0"})
            EXPECT_EQ(broken(promise, test::set_of(rows), 3), std::nullopt) << promise;
        rows[7][1] = rows[8][1];
        for (const char* const promise : {"latin", "net:0"})
            EXPECT_TRUE(broken(promise, test::set_of(rows), 3)) << promise;
    }
}

// The requirements are exact, so the only risk is a set that keeps a promise by chance.
TEST(Promises, FailWhereOneSetBreaksThem) {
    const auto sampler = test::sampler_of("latin_but_once", [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        const bool once = random() % 8 == 0;
        auto rows = test::latin_rows(n, d, random);
        if (once) rows[5][1] = rows[6][1];
        return rows;
    });
    SamplerCheckRequest request{.points = 50, .dimension = 2, .trials = 200};
    request.promises = {parse_promise("latin")};
    const auto checks = check_sampler(sampler->entry(), request);
    EXPECT_THAT(test::found(checks, SamplerVerdict::fail, "promise: latin"),
                testing::ElementsAre(HasSubstr("coordinate 1: slice ")));
    const auto sound = check_sampler(samplers::find("latin_hypercube"), request);
    EXPECT_THAT(test::found(sound, SamplerVerdict::pass, "promise: latin"), SizeIs(1));
    EXPECT_THAT(test::found(sound, SamplerVerdict::fail), IsEmpty());
    request.promises = {parse_promise("net:0")};
    EXPECT_THROW(check_sampler(sampler->entry(), request), UserError);
}

}  // namespace
}  // namespace ff::studies
