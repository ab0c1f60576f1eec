#include "reports/pictures/line_labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::reports {
namespace {

using nlohmann::json;

json set(const LineLabels& labels) {
    PictureValues values({"x"});
    labels.set(values, nlohmann::ordered_json::object());
    return json::parse(values.text());
}

std::vector<double> heights(const json& values) {
    std::vector<double> found;
    for (const json& label : values["labels"]) found.push_back(std::log(label["height"].get<double>()));
    std::sort(found.begin(), found.end());
    return found;
}

TEST(LineLabels, KeepTheirDistanceWithinTheAxis) {
    LineLabels labels(HeightAxis::logarithmic);
    for (const double error : {1e-4, 1.0}) labels.make_room(error);
    for (int i = 0; i < 7; ++i) labels.add("m", "m", 1.0);  // all at the upper end
    const json values = set(labels);
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
    LineLabels labels(HeightAxis::linear);
    for (const double value : {0.0, 1.0}) labels.make_room(value);
    labels.add("a", "a", 0.2);
    labels.add("b", "b", 0.7);
    const json values = set(labels);
    EXPECT_EQ(values["labels"][0]["height"], 0.2);
    EXPECT_EQ(values["labels"][1]["height"], 0.7);
}

TEST(LineLabels, LeaveTheAxisAloneWhereNothingIsDrawn) {
    const json values = set(LineLabels(HeightAxis::logarithmic));
    EXPECT_FALSE(values["scales"].contains("y"));
}

}  // namespace
}  // namespace ff::reports
