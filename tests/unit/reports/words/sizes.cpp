#include "reports/words/sizes.hpp"

#include "reports/html/html.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/tables/tables.hpp"
#include "reports/terminal/terminal.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A long ladder (cells 0 .. 5) and a short one (6 .. 8).
const studies::StudyResults& long_and_short_ladder() {
    static const studies::StudyResults made = studies::evaluate(test::run(test::plan_of(R"([study]
name = "ladders"
scene = "cube"
trials = 20
seed = 3

[[method]]
name = "long"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [64, 128, 256, 512, 1024, 2048]

[[method]]
name = "short"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256, 1024]
)")));
    return made;
}

TEST(CellsInBetween, AreTheMiddleOfLongLaddersOnly) {
    EXPECT_EQ(cells_in_between(long_and_short_ladder()), (std::set<std::size_t>{1, 2, 3}))
        << "the verdict compares at 1024 rays";
    EXPECT_TRUE(cells_in_between(test::published_results()).empty());
}

TEST(CellsInBetween, AreShownWhenSomethingIsWrong) {
    studies::StudyResults results = long_and_short_ladder();
    results.findings.cells[2].lost_rays = 1;
    ASSERT_TRUE(results.findings.cells[3].bias);
    results.findings.cells[3].bias_finding = studies::BiasFinding::biased;
    EXPECT_EQ(cells_in_between(results), (std::set<std::size_t>{1}));
}

TEST(CellsInBetween, AreLeftOutOfTablesAndGroupsOfPictures) {
    const Table table = methods_table(long_and_short_ladder());
    EXPECT_EQ(table.rows.size(), 6u);
    EXPECT_THAT(table.remarks.back(), HasSubstr("3 sizes"));
    const auto groups = picture_groups(long_and_short_ladder());
    EXPECT_THAT(groups, testing::SizeIs(6));
    const std::string page = html_report(long_and_short_ladder(), test::shipped_templates());
    EXPECT_THAT(page, HasSubstr("long, 1 × 2048 rays, pair by pair"));
    EXPECT_THAT(page, Not(HasSubstr("long, 1 × 256 rays, pair by pair")));
}

TEST(TerminalSummary, DrawsLaddersWithLetters) {
    const std::string text = terminal_summary(long_and_short_ladder());
    EXPECT_THAT(text, HasSubstr("evaluations per face, adjacent pairs\n"));
    EXPECT_THAT(text, HasSubstr("a long   b short\n"));
    EXPECT_THAT(terminal_summary(test::published_results()), Not(HasSubstr("evaluations per face")));
}

}  // namespace
}  // namespace ff::reports
