#include "reports/pictures/method_styles.hpp"

#include "reports/words/answer.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using nlohmann::json;

/// Lines of methods in colour.
MethodLines lines_of(const std::vector<std::string>& methods, HeightAxis axis) {
    std::vector<MethodStyle> styles;
    for (const std::string& method : methods) styles.push_back({method, "#0072b2", "circle"});
    return {std::move(styles), axis};
}

json set(const MethodLines& lines) {
    PictureValues values({"x"});
    lines.set(values);
    return json::parse(values.text());
}

std::vector<double> heights(const json& values) {
    std::vector<double> found;
    for (const json& label : values["labels"]) found.push_back(std::log(label["height"].get<double>()));
    std::sort(found.begin(), found.end());
    return found;
}

TEST(LineLabels, KeepTheirDistanceWithinTheAxis) {
    MethodLines lines = lines_of({"m"}, HeightAxis::logarithmic);
    for (const double error : {1e-4, 1.0}) lines.make_room(error);
    for (int i = 0; i < 7; ++i) {
        lines.begin("m", "m");
        lines.add(1.0);  // at the upper end
    }
    const json values = set(lines);
    const double low = std::log(values["scales"]["y"]["domain"][0].get<double>());
    const double high = std::log(values["scales"]["y"]["domain"][1].get<double>());
    const auto found = heights(values);
    ASSERT_EQ(found.size(), 7u);
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_GE(found[i] - found[i - 1], 0.99 * (high - low) / 20) << "a row of text is a twentieth of the height";
    EXPECT_LE(found.back(), high + 1e-3);
    EXPECT_GE(found.front(), low);
}

TEST(LineLabels, StayWhereNothingIsNear) {
    MethodLines lines = lines_of({"a", "b"}, HeightAxis::linear);
    for (const double value : {0.0, 1.0}) lines.make_room(value);
    lines.begin("a", "a");
    lines.add(0.2);
    lines.begin("b", "b");
    lines.add(0.7);
    const json values = set(lines);
    EXPECT_EQ(values["labels"][0]["height"], 0.2);
    EXPECT_EQ(values["labels"][1]["height"], 0.7);
}

TEST(LineLabels, LeaveTheAxisAloneWhereNothingIsDrawn) {
    const json values = set(lines_of({}, HeightAxis::logarithmic));
    EXPECT_FALSE(values["scales"].contains("y"));
}

// Of ten methods five err alike and less than the others: the answer names all of them.
TEST(MethodStyles, AreInColourForEveryMethodThatTheAnswerNames) {
    std::string methods;
    for (int i = 0; i < 10; ++i) {
        methods += fmt::format(
            "[[method]]\nname = \"m{}\"\nsampler = \"sobol\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 4096\n",
            i);
    }
    const auto store = test::fill(test::plan_of(test::study_text("trials = 64", methods)),
                                  [](std::size_t cell, std::uint64_t trial, int from, int to) {
                                      const auto pair =
                                          6 * static_cast<std::size_t>(from) + static_cast<std::size_t>(to);
                                      const std::size_t mixed = (cell + 1) * 2654435761u ^ (trial + 1) * 40503u * pair;
                                      const double sign = mixed >> 7 & 1u ? 1 : -1;
                                      return 0.2 + sign * (cell < 5 ? 0.05 : 0.005);
                                  });
    const auto results = studies::evaluate(store);
    const auto rankings = answer(results).finding.rankings;
    ASSERT_FALSE(rankings.empty());
    EXPECT_THAT(rankings.front().leaders, testing::UnorderedElementsAre("m5", "m6", "m7", "m8", "m9"));
    for (const MethodStyle& style : method_styles(results)) {
        const bool is_named = style.method >= "m5";
        EXPECT_TRUE(style.in_colour || !is_named) << style.method;
    }
}

}  // namespace
}  // namespace ff::reports
