#include "studies/readers/json_reader.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

std::string refusal_of_json(std::string_view text) {
    return test::message_of<UserError>([&] { parse_json(text, "t.json"); });
}

TEST(ParseJson, LocatesEveryValue) {
    const JsonValue root = parse_json("{\n  \"a\": [1, \"x\\\"y\", null],\n  \"b\": true, \"c\": -2.5e1\n}", "t.json");
    EXPECT_EQ(root.kind, JsonValue::Kind::object);
    EXPECT_EQ(root.position.line, 1);
    const JsonValue& a = *root.find("a");
    EXPECT_EQ(a.position.line, 2);
    EXPECT_EQ(a.position.column, 8);
    ASSERT_EQ(a.items.size(), 3u);
    EXPECT_EQ(a.items[0].position.column, 9);
    EXPECT_EQ(a.items[1].position.column, 12);
    EXPECT_EQ(a.items[1].text, "x\"y");
    EXPECT_EQ(a.items[2].position.column, 20);
    EXPECT_EQ(root.find("b")->position.column, 8);
    EXPECT_EQ(root.find("b")->number, 1);
    EXPECT_EQ(root.find("c")->position.column, 19);
    EXPECT_EQ(root.find("c")->number, -25);
    EXPECT_EQ(root.find("d"), nullptr);
}

TEST(ParseJson, PointsAtASyntaxError) {
    EXPECT_THAT(refusal_of_json("{\n  \"a\": [1, 2,\n  ]}"), testing::StartsWith("t.json:3:3: this is not JSON"));
    EXPECT_THAT(refusal_of_json("{\"a\": 1"), testing::StartsWith("t.json:1:"));
    EXPECT_THAT(refusal_of_json(""), testing::StartsWith("t.json:1:1: this is not JSON"));
    EXPECT_THAT(refusal_of_json("{} {}"), testing::StartsWith("t.json:1:4: this is not JSON"));
}

TEST(ParseJson, RefusesDuplicateKeys) {
    EXPECT_THAT(refusal_of_json("{\"a\": 1,\n \"a\": 2}"),
                testing::StartsWith("t.json:2:2: the key \"a\" stands twice"));
}

}  // namespace
}  // namespace ff::studies
