#include "reports/text/table.hpp"

#include <gtest/gtest.h>

namespace ff::reports {
namespace {

Table table(std::vector<std::vector<TableCell>> rows) {
    Table made;
    made.columns = {{"method", false, ""}, {"slope", true, ""}, {"theory", false, ""}, {"remark", false, ""}};
    made.rows = std::move(rows);
    return made;
}

TEST(Columns, AreNumericOrMinorAsTheSignsBeforeTheirTitlesSay) {
    const auto made = columns({"method", ">slope", "~theory", ">~p", ""});
    ASSERT_EQ(made.size(), 5u);
    const std::vector<std::string> titles{made[0].title, made[1].title, made[2].title, made[3].title, made[4].title};
    EXPECT_EQ(titles, (std::vector<std::string>{"method", "slope", "theory", "p", ""}));
    const std::vector<bool> numbers{made[0].number, made[1].number, made[2].number, made[3].number, made[4].number};
    EXPECT_EQ(numbers, (std::vector<bool>{false, true, false, true, false}));
    const std::vector<bool> minor{made[0].minor, made[1].minor, made[2].minor, made[3].minor, made[4].minor};
    EXPECT_EQ(minor, (std::vector<bool>{false, false, true, true, false}));
}

TEST(IdleColumns, AreLeftOutOfEveryRow) {
    const Table left =
        without_idle_columns(table({{{""}, {"-0.5"}, {"none known"}, {"–"}}, {{""}, {"–"}, {""}, {""}}}));
    ASSERT_EQ(left.columns.size(), 2u);
    EXPECT_EQ(left.columns[0].title, "method");
    EXPECT_EQ(left.columns[1].title, "slope");
    for (const auto& row : left.rows) EXPECT_EQ(row.size(), 2u);
}

TEST(IdleColumns, AreKeptWhenAnyRowHasAValue) {
    EXPECT_EQ(
        without_idle_columns(table({{{"a"}, {"1"}, {"–"}, {""}}, {{"b"}, {"–"}, {"-0.5"}, {"!"}}})).columns.size(), 4u);
}

TEST(IdleColumns, StayInATableWithoutRows) {
    EXPECT_EQ(without_idle_columns(table({})).columns.size(), 4u);
}

}  // namespace
}  // namespace ff::reports
