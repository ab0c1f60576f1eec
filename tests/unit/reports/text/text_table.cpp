#include "reports/text/text_table.hpp"
#include "reports/text/folding.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace ff::reports {
namespace {

Table errors() {
    return {"errors",
            "",
            "",
            {{"method", false, ""}, {"parallel", true, "RMSE"}, {"adjacent", true, "RMSE"}, {"verdict", false, ""}},
            {{{"sobol", Mark::none}, {"1.5e-3", Mark::none}, {"2e-3", Mark::none}, {"no bias found", Mark::good}},
             {{"random", Mark::none}, {"0.1", Mark::none}, {"", Mark::none}, {"", Mark::none}}},
            {}};
}

TEST(TextTable, IsNoWiderThanNecessary) {
    EXPECT_EQ(text_table(errors(), {}),
              "            RMSE\n"
              "method  parallel  adjacent  verdict\n"
              "sobol     1.5e-3      2e-3  no bias found\n"
              "random       0.1\n");
}

TEST(TextTable, WrapsAtTheWidthOfTheTerminal) {
    EXPECT_EQ(text_table(errors(), {Colour::none, 30}),
              "            RMSE\n"
              "method  parallel  adjacent\n"
              "sobol     1.5e-3      2e-3\n"
              "    verdict: no bias found\n"
              "random       0.1\n");
}

TEST(TextTable, FoldsTitlesBeforeItDividesRows) {
    Table table{"sizes",
                "",
                "",
                columns({"method", "size (patches per face)", ">bias found"}),
                {{"sobol", "1 × 4096 rays", "none"}}};
    EXPECT_EQ(text_table(table, {}),
              "method  size (patches per face)  bias found\n"
              "sobol   1 × 4096 rays                  none\n");
    EXPECT_EQ(text_table(table, {Colour::none, 30}),
              "        size (patches   bias\n"
              "method  per face)      found\n"
              "sobol   1 × 4096 rays   none\n");
}

TEST(TextTable, NamesTheGroupsOfCellsBelowARow) {
    EXPECT_EQ(text_table(errors(), {Colour::none, 20}),
              "            RMSE\n"
              "method  parallel\n"
              "sobol     1.5e-3\n"
              "    RMSE adjacent:\n"
              "    2e-3; verdict:\n"
              "    no bias found\n"
              "random       0.1\n");
}

TEST(TextTable, StaysWithinAnyWidthThatHoldsItsCells) {
    for (std::size_t width = 17; width < 50; ++width) {
        std::istringstream lines(text_table(errors(), {Colour::none, width}));
        for (std::string line; std::getline(lines, line);) EXPECT_LE(visible_length(line), width) << line;
    }
}

TEST(TextTable, BreaksACellWiderThanTheTerminal) {
    Table table;
    table.columns = {{"method", false, ""}, {"verdict", false, ""}};
    table.rows = {{{"sobol"}, {"different: the errors of the two runs differ by a factor of 2"}}};
    EXPECT_EQ(text_table(table, {Colour::none, 30}),
              "method\nsobol\n    verdict: different: the\n    errors of the two runs\n    differ by a factor of 2\n");
}

TEST(TextTable, IgnoresColourCodesInWidths) {
    EXPECT_NE(text_table(errors(), {Colour::ansi, 41}).find("2e-3  \033[32mno bias found\033[0m\n"), std::string::npos);
}

}  // namespace
}  // namespace ff::reports
