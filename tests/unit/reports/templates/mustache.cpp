#include "reports/templates/mustache.hpp"

#include "core/support/error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ff::reports {
namespace {

using Json = nlohmann::ordered_json;

std::string fill(std::string text, const Json& view) {
    return fill_template(Templates({{"page.mustache", std::move(text)}, {"part.mustache", "[{{x}}]"}}), "page", view,
                         escape_html);
}

TEST(Mustache, EscapesTextAndLeavesTriplesAlone) {
    EXPECT_EQ(fill("{{x}} {{{x}}}", {{"x", "<a href=\"'&\">"}}),
              "&lt;a href=&quot;&#39;&amp;&quot;&gt; <a href=\"'&\">");
}

TEST(Mustache, HandlesListsPartialsAndMissingValues) {
    const Json view{{"list", {{{"x", "1"}}, {{"x", "2"}}}}, {"empty", ""}, {"none", nullptr}, {"no", false}};
    EXPECT_EQ(fill("{{#list}}{{>part}}{{/list}}", view), "[1][2]");
    EXPECT_EQ(fill("{{#empty}}a{{/empty}}{{#none}}b{{/none}}{{#no}}c{{/no}}{{^no}}d{{/no}}", view), "d");
}

TEST(Mustache, RefusesMalformedOrMissingTemplates) {
    EXPECT_THROW(fill("{{#open}}", Json::object()), UserError);
    EXPECT_THROW(fill("{{#a\x1b}}", Json::object()), UserError);
    EXPECT_THROW(fill_template(Templates({}), "page", Json::object(), escape_html), UserError);
}

TEST(Mustache, RefusesTemplatesThatIncludeThemselves) {
    EXPECT_THROW(fill("{{>page}}", Json::object()), UserError);
    EXPECT_THROW(fill("{{#no}}{{> page }}{{/no}}", {{"no", false}}), UserError);
    const Templates circle(
        {{"page.mustache", "{{=<% %>=}}<%>a%>"}, {"a.mustache", "{{>b}}"}, {"b.mustache", "{{>a}}"}});
    EXPECT_THROW(fill_template(circle, "page", Json::object(), escape_html), UserError);
    EXPECT_EQ(fill("{{>part}}{{>part}}{{>none}}", {{"x", "1"}}), "[1][1]");
}

}  // namespace
}  // namespace ff::reports
