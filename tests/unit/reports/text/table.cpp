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
