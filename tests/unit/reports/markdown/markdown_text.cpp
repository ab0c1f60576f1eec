#include "reports/markdown/markdown_text.hpp"

#include "reports/markdown/markdown.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MarkdownText, LeavesOrdinaryNamesAndNumbersAlone) {
    for (const char* text : {"Sobol' rays", "SR_625", "sobol_lms, 169 × 625 rays", "0.998 [0.997, 0.999]", "p < 1e-10",
                             "R & D", "a_b_c", "#1 (best) + 2 - 3", "Σ_ü", "F 1-6: a|b"})
        EXPECT_EQ(markdown_text(text), text);
}

TEST(MarkdownText, EscapesCharactersOfMarkup) {
    EXPECT_EQ(markdown_text("<b>x</b>"), "\\<b>x\\</b>");
    EXPECT_EQ(markdown_text("<!-- x"), "\\<!-- x");
    EXPECT_EQ(markdown_text("[a](javascript:b)"), "[a\\](javascript:b)");
    EXPECT_EQ(markdown_text("&lt;&#60;"), "\\&lt;\\&#60;");
    EXPECT_EQ(markdown_text("a*b*`c`~~d~~"), "a\\*b\\*\\`c\\`\\~\\~d\\~\\~");
    EXPECT_EQ(markdown_text("_a_ __b__"), "\\_a\\_ \\_\\_b\\_\\_");
    EXPECT_EQ(markdown_text("a\\<b"), "a\\\\\\<b");
    EXPECT_EQ(markdown_cell("a|b\\|c"), "a\\|b\\\\\\|c");
}

TEST(MarkdownCode, IsNotClosedByItsContents) {
    EXPECT_EQ(markdown_code("toml", "a\n"), "```toml\na\n```\n");
    EXPECT_EQ(markdown_code("toml", "# ```\n# </details>\n"), "````toml\n# ```\n# </details>\n````\n");
}

TEST(MarkdownReport, EscapesMarkupInNames) {
    studies::StudyResults results = test::small_results();
    results.findings.plan.spec.title = "A <b>title</b>";
    const std::string name = "<img src=x>[y](javascript:z)";
    for (studies::Method& method : results.findings.plan.spec.methods) method.name += name;
    const std::string text = markdown_report(results);
    const std::string told = text.substr(0, text.find("## Reproduce"));
    EXPECT_THAT(told, testing::StartsWith("# A \\<b>title\\</b>\n"));
    EXPECT_THAT(told, HasSubstr("\\<img src=x>[y\\](javascript:z)"));
    for (std::size_t at = told.find("<img"); at != std::string::npos; at = told.find("<img", at + 1))
        EXPECT_EQ(told[at - 1], '\\') << told.substr(at - 80, 160);
    EXPECT_THAT(told, Not(HasSubstr("[y](")));
}

}  // namespace
}  // namespace ff::reports
