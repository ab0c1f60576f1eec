#include "reports/latex/latex.hpp"

#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace ff::reports {
namespace {

using test::shipped_templates;
using testing::HasSubstr;
using testing::Not;

/// Rows of the tabular material whose number of cells differs from the header's; those that span are left out.
std::vector<std::string> unbalanced_rows(const std::string& text) {
    const auto cells = [](const std::string& line) {
        std::ptrdiff_t count = 1;
        for (std::size_t i = 0; i < line.size(); ++i)
            count += line[i] == '&' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
        return count;
    };
    std::vector<std::string> unbalanced;
    std::ptrdiff_t wanted = 0;
    for (const std::string& line : test::lines_of(text)) {
        if (!line.ends_with("\\\\") || line.starts_with("\\caption") ||
            line.find("multicolumn{") != line.rfind("multicolumn{"))
            continue;
        if (line.starts_with("\\multicolumn")) continue;
        if (wanted == 0) wanted = cells(line);
        if (cells(line) != wanted) unbalanced.push_back(line);
    }
    return unbalanced;
}

Table small_table() {
    return {"t", "Title", "", {{"", false, ""}, {"a", true, ""}}, {{{"x"}, {"1"}}}, {}};
}

TEST(EscapeLatex, EscapesCharactersOfCommands) {
    EXPECT_EQ(escape_latex("a&b%c_d$e#f"), "a\\&b\\%c\\_d\\$e\\#f");
    EXPECT_EQ(escape_latex("\\~^{}"), "\\textbackslash{}\\~{}\\^{}\\{\\}");
    EXPECT_EQ(escape_latex("[2] *"), "{[}2] {*}");
    EXPECT_EQ(escape_latex("<|>\""), "\\textless{}\\textbar{}\\textgreater{}\\char34{}");
}

TEST(EscapeLatex, SeparatesCharactersThatWouldFormLigatures) {
    EXPECT_EQ(escape_latex("a--b"), "a-{}-b");
    EXPECT_EQ(escape_latex("``x''"), "`{}`x'{}'");
    EXPECT_EQ(escape_latex("?`"), "?{}`");
}

TEST(EscapeLatex, LetsNoControlCharacterThrough) {
    EXPECT_EQ(escape_latex("a\n\nb\tc\x7f"), "a  b c ");
}

TEST(EscapeLatex, WritesSignsOfReportsAndKeepsLetters) {
    EXPECT_EQ(escape_latex("Σ ± 5²"), "\\ensuremath{\\Sigma} \\ensuremath{\\pm} 5\\textsuperscript{2}");
    EXPECT_EQ(escape_latex("Größe"), "Größe");
}

TEST(LatexWithNumbers, SetsSignsAndExponents) {
    EXPECT_EQ(latex_with_numbers("-7.2e-05"), "$-7.2\\times10^{-5}$");
    EXPECT_EQ(latex_with_numbers("[+0.1, 1e+10]"), "{[}$+0.1$, $1\\times10^{10}$]");
    EXPECT_EQ(latex_with_numbers("0.25"), "0.25");
}

TEST(LatexWithNumbers, DoesNotMistakeNamesForNumbers) {
    EXPECT_EQ(latex_with_numbers("F 1-6"), "F 1-6");
    EXPECT_EQ(latex_with_numbers("b1e5"), "b1e5");
}

TEST(LatexTable, HasEquallyManyCellsInEveryRow) {
    for (const auto* results : {&test::small_results(), &test::published_results()}) {
        for (const NamedText& file : latex_report(*results, shipped_templates()))
            EXPECT_THAT(unbalanced_rows(file.text), testing::IsEmpty()) << file.path;
    }
}

TEST(LatexTable, IsFoundUnbalancedWithAnUnescapedAmpersand) {
    EXPECT_THAT(unbalanced_rows("a & b \\\\\na & b & c \\\\\n"), testing::SizeIs(1));
    EXPECT_THAT(unbalanced_rows("a & b \\\\\na \\& b & c \\\\\n"), testing::IsEmpty());
}

TEST(LatexTable, StacksGroupsWithEqualColumns) {
    Table table = small_table();
    table.columns = {
        {"", false, ""}, {"printed", true, "36"}, {"ours", true, "36"}, {"printed", true, "81"}, {"ours", true, "81"}};
    table.rows = {{{"1 - 6"}, {"0.1"}, {"0.2"}, {"0.3"}, {"0.4"}}, {{"1 - 2"}, {""}, {""}, {"0.5"}, {"0.6"}}};
    const std::string text = latex_table(table, shipped_templates());
    EXPECT_THAT(text,
                HasSubstr("\\multicolumn{3}{l}{\\textit{36}} \\\\\n1 - 6 & 0.1 & 0.2 \\\\\n\\addlinespace\n"
                          "\\multicolumn{3}{l}{\\textit{81}} \\\\\n1 - 6 & 0.3 & 0.4 \\\\\n1 - 2 & 0.5 & 0.6 \\\\"));
}

TEST(LatexTable, MarksMisprintsAndSaysWhatTheMarkMeans) {
    Table table = small_table();
    EXPECT_THAT(latex_table(table, shipped_templates()), Not(HasSubstr("contradicts")));
    table.rows[0][1].mark = Mark::misprint;
    EXPECT_THAT(latex_table(table, shipped_templates()),
                testing::AllOf(HasSubstr("1\\ensuremath{^\\dagger}"), HasSubstr("contradicts")));
}

TEST(LatexTable, IsBrokenAcrossPagesWhereItIsLong) {
    Table table = small_table();
    EXPECT_THAT(latex_table(table, shipped_templates()), HasSubstr("\\begin{tabular}"));
    table.rows.resize(41, table.rows.front());
    EXPECT_THAT(latex_table(table, shipped_templates()), HasSubstr("\\begin{longtable}"));
}

TEST(LatexReport, IncludesEveryTableOnce) {
    const auto files = latex_report(test::published_results(), shipped_templates());
    std::set<std::string> paths;
    for (const NamedText& file : files) EXPECT_TRUE(paths.insert(file.path).second) << file.path;
    for (const std::string& path : paths) {
        const std::string input = "\\input{" + path + "}";
        EXPECT_EQ(files.front().text.find(input) != std::string::npos, path != "tables.tex") << path;
    }
    for (const char* path : {"tables.tex", "tables/methods.tex", "tables/table1.tex", "tables/claims.tex"})
        EXPECT_TRUE(paths.contains(path)) << path;
    EXPECT_TRUE(paths.lower_bound("tables/pairs-0-")->starts_with("tables/pairs-0-")) << "with method and size";
}

TEST(LatexReport, SeparatesTablesWithSimilarNames) {
    studies::StudyResults results = test::published_results();
    results.published->tables.tables[0].id = "methods";
    std::set<std::string> paths;
    for (const NamedText& file : latex_report(results, shipped_templates()))
        EXPECT_TRUE(paths.insert(file.path).second) << file.path;
    results.published->tables.tables[0].id = "../Таблица";
    for (const NamedText& file : latex_report(results, shipped_templates()))
        EXPECT_THAT(file.path, Not(HasSubstr("..")));
}

}  // namespace
}  // namespace ff::reports
