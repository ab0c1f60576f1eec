#include "studies/spec/spec.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace ff::studies {
namespace {

using test::random_rays;
using test::study_text;

TEST(SetTrials, ScalesSizesThatHaveTheirOwnNumber) {
    StudySpec spec;
    spec.trials = 1000;
    spec.methods.resize(1);
    spec.methods.front().sizes = {{1, 10, std::nullopt}, {4, 10, 100}, {9, 10, 1000}};
    set_trials(spec, 50);
    EXPECT_EQ(spec.trials, 50u);
    EXPECT_EQ(spec.methods.front().sizes[0].trials, std::nullopt);
    EXPECT_EQ(spec.methods.front().sizes[1].trials, 5u);
    EXPECT_EQ(spec.methods.front().sizes[2].trials, 50u);
    set_trials(spec, 2);
    EXPECT_EQ(spec.methods.front().sizes[1].trials, 2u);  // an interval needs two
}

TEST(SetTrials, ChangesNothingWhereTheNumberIsTheSame) {
    for (std::uint64_t trials = 2; trials < 200; ++trials) {
        for (std::uint64_t own = 2; own < 2 * trials; ++own) {
            StudySpec spec;
            spec.trials = trials;
            spec.methods.resize(1);
            spec.methods.front().sizes = {{1, 10, own}};
            set_trials(spec, trials);
            ASSERT_EQ(spec.methods.front().sizes.front().trials, own) << "of " << trials;
        }
    }
}

TEST(SetTrials, RefusesFewerThanTwoGroupsOfCoverage) {
    StudySpec spec =
        parse_study(study_text("trials = 60\n[coverage]\nreplicates = [5, 30]", random_rays), "study.toml");
    EXPECT_NO_THROW(set_trials(spec, 60));
    EXPECT_THROW(set_trials(spec, 59), UserError);
}

TEST(SetTrials, RefusesFewerThanTwo) {
    StudySpec spec = parse_study(study_text("trials = 9", random_rays), "study.toml");
    EXPECT_THROW(set_trials(spec, 0), UserError);
    EXPECT_THROW(set_trials(spec, 1), UserError);
    EXPECT_THROW(set_trials(spec, (1ULL << 32) + 1), UserError);
    EXPECT_EQ(spec.trials, 9u);
}

}  // namespace
}  // namespace ff::studies
