#include "studies/run/merge.hpp"

#include "core/support/error.hpp"
#include "studies/run/run.hpp"
#include "studies/store/sqlite.hpp"
#include "tests/support/earlier_stores.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

using test::rows_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Five units: a size each.
StudyPlan five_units(std::string_view lines = "trials = 3") {
    return test::plan_of(
        test::study_text(lines,
                         "[[method]]\nname = \"rays\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
                         "patches_per_face = 4\nsamples_per_patch = [1, 2, 3]\n"
                         "[[method]]\nname = \"kernel\"\nsampler = \"random\"\nestimator = \"area_kernel\"\n"
                         "samples_per_patch = [4, 5]\n"));
}

class Merge : public testing::Test {
  protected:
    std::filesystem::path file(std::string_view name) const { return folder.path() / name; }

    /// Runs a share of the study into a file of this name.
    std::filesystem::path shard(std::string_view name, Shard share, const StudyPlan& plan = five_units()) const {
        Store store = Store::create_or_resume(file(name), plan);
        RunOptions options;
        options.shard = share;
        EXPECT_EQ(run_study(store, options), RunOutcome::complete);
        store.set_context({{"host", std::string(name)}, {"version", "1"}});
        return file(name);
    }
    std::vector<std::string> rows_of_one_run() const {
        test::run(five_units(), file("whole"));
        return rows_of(file("whole"));
    }
    /// The message that refuses a merge into "target".
    std::string refusal(const std::vector<std::filesystem::path>& sources) const {
        Store target = Store::create_or_resume(file("target"), five_units());
        try {
            merge_stores(sources, target);
        } catch (const UserError& error) {
            return error.what();
        }
        return "nothing thrown";
    }
    test::TemporaryFolder folder;
};

TEST_F(Merge, GivesTheRowsOfOneRunForAnySplit) {
    const auto rows = rows_of_one_run();
    for (std::uint64_t count = 1; count <= 6; ++count) {  // the sixth of six has nothing to do
        std::vector<std::filesystem::path> sources;
        for (std::uint64_t index = count; index >= 1; --index)
            sources.push_back(shard(fmt::format("{}of{}", index, count), {index, count}));
        Store target = Store::create_or_resume(file(fmt::format("merged{}", count)), five_units());
        const auto outcome = merge_stores(sources, target);
        EXPECT_THAT(outcome.missing, IsEmpty());
        EXPECT_THAT(outcome.doubled, IsEmpty());
        target.seal();
        EXPECT_EQ(rows_of(file(fmt::format("merged{}", count))), rows);
    }
}

TEST_F(Merge, NamesMissingAndDuplicateUnits) {
    Store target = Store::create_or_resume(file("target"), five_units());
    const auto second = shard("second", {2, 3});
    const auto outcome = merge_stores({second, second}, target);
    EXPECT_THAT(outcome.missing, ElementsAre(0, 2, 3));
    EXPECT_THAT(outcome.doubled, ElementsAre(1, 4));
    EXPECT_FALSE(target.is_complete());
}

TEST_F(Merge, TakesNoLockOnItsSources) {
    Store target = Store::create_or_resume(file("target"), five_units());
    const auto whole = shard("whole", {1, 1});
    const Database writer(whole, Database::Mode::create_or_open);
    writer.execute("BEGIN IMMEDIATE");
    EXPECT_THAT(merge_stores({whole}, target).missing, IsEmpty());
}

TEST_F(Merge, IsIdempotent) {
    Store target = Store::create_or_resume(file("target"), five_units());
    const auto first = shard("first", {1, 2});
    const auto second = shard("second", {2, 2});
    merge_stores({first}, target);
    const auto outcome = merge_stores({first, second}, target);
    EXPECT_THAT(outcome.missing, IsEmpty());
    EXPECT_THAT(outcome.doubled, IsEmpty());  // no two of the sources hold one unit
    target.seal();
    EXPECT_EQ(rows_of(file("target")), rows_of_one_run());
}

TEST_F(Merge, KeepsTheCircumstancesOfAllSourcesInSeveralSteps) {
    Store target = Store::create_or_resume(file("target"), five_units());
    for (const char* host : {"a", "b", "a"}) {
        const auto source = shard(host, {*host == 'a' ? 1u : 2u, 2});
        Store::create_or_resume(source, five_units()).set_context({{"host", host}});
        merge_stores({source}, target);
    }
    EXPECT_EQ(target.context(), (Context{{"host", "a; b"}}));
}

TEST_F(Merge, ReportsNothingMissingFromAFinishedAdaptiveStudy) {
    const StudyPlan plan = test::plan_of(test::study_text("trials = 1000",
                                                          "[[method]]\nname = \"a\"\nsampler = \"random\"\n"
                                                          "estimator = \"ray_shooting\"\nsamples_per_patch = 10000\n"
                                                          "[until]\nrmse = 0.01\npilot = 5\n"));
    const auto whole = shard("whole", {1, 1}, plan);
    Store target = Store::create_or_resume(file("target"), plan);
    EXPECT_THAT(merge_stores({whole}, target).missing, IsEmpty());
    EXPECT_FALSE(target.is_complete()) << "it should not have needed all trials";
}

TEST_F(Merge, RefusesADuplicateUnitWithDifferentContent) {
    const auto whole = shard("whole", {1, 1});
    for (const char* damage : {"UPDATE observations SET value = 0 WHERE observable = 'hits' AND cell = 1 AND trial = 2",
                               "UPDATE observations SET value = value * (1 + 1e-15) WHERE cell = 4",
                               "UPDATE units SET patch_hits = zeroblob(length(patch_hits)) WHERE unit = 1"}) {
        const auto part = file("part");
        std::filesystem::remove(part);
        shard("part", {2, 3});
        Database database(part, Database::Mode::create_or_open);
        database.execute(test::store_as_version_1);
        database.execute(damage);
        std::filesystem::remove(file("target"));
        EXPECT_THAT(refusal({whole, part}), HasSubstr("differs from the same unit")) << damage;
    }
}

TEST_F(Merge, AcceptsStoresOfAnEarlierVersion) {
    const auto rows = rows_of_one_run();
    const std::vector parts{shard("part1", {1, 2}), shard("part2", {2, 2})};
    Database(parts[1], Database::Mode::create_or_open).execute(test::store_as_version_1);
    {
        Store target = Store::create_or_resume(file("target"), five_units());
        const auto outcome = merge_stores(parts, target);
        EXPECT_THAT(outcome.missing, IsEmpty());
        EXPECT_THAT(outcome.unchecked, ElementsAre(1));
    }
    EXPECT_TRUE(Store::open(file("target")).was_checked());
    EXPECT_EQ(rows_of(file("target")), rows);
}

TEST_F(Merge, RefusesAnotherStudy) {
    const auto other = shard("other", {1, 2}, five_units("trials = 4"));
    EXPECT_THAT(refusal({shard("part", {2, 2}), other}),
                HasSubstr("other: holds another study (differs in [study]: 'trials = 4' there, 'trials = 3' here)"));
}

TEST_F(Merge, KeepsTheCircumstancesOfAllSources) {
    Store target = Store::create_or_resume(file("target"), five_units());
    merge_stores({shard("a", {1, 3}), shard("b", {2, 3})}, target);
    EXPECT_EQ(target.context(), (Context{{"host", "a; b"}, {"version", "1"}}));
}

}  // namespace
}  // namespace ff::studies
