#include "studies/store/store.hpp"

#include "core/support/error.hpp"
#include "studies/run/run.hpp"
#include "tests/support/full_disk.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <barrier>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace ff::studies {
namespace {

using test::in_memory;
using test::message_of;
using test::plan_of;
using test::study_text;
using testing::HasSubstr;

constexpr std::string_view rays_method = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = 4
samples_per_patch = 100
)";

constexpr std::string_view published_tables =
    R"({"source": "s", "scene": "cube", "methods": [{"name": "SR", "samples": true, "completion": "direct"}], "tables": []})";

StudyPlan store_plan(std::string_view lines = "trials = 3") {
    return plan_of(study_text(lines, rays_method));
}

class StoreFile : public testing::Test {
  protected:
    std::filesystem::path file() const { return folder.path() / "results.sqlite"; }
    std::string refusal_to_resume(const StudyPlan& other) const {
        return message_of<UserError>([&] { Store::create_or_resume(file(), other); });
    }
    template <typename Error>
    std::string refusal_to_open() const {
        return message_of<Error>([&] { Store::open(file()); });
    }
    static std::string journal_mode(const Store& store) {
        Statement mode(store.database().handle(), "PRAGMA journal_mode");
        return mode.step() ? mode.text(0) : std::string();
    }
    void execute(const char* sql) const { Database(file(), Database::Mode::create_or_open).execute(sql); }
    test::TemporaryFolder folder;
};

TEST_F(StoreFile, OpensWithThePlanThatItWasMadeFor) {
    const StudyPlan made = store_plan();
    test::run(made, file());
    const Store store = Store::open(file());
    EXPECT_EQ(store.plan().spec, made.spec);
    EXPECT_EQ(store.plan().cells.at(0).key, made.cells.at(0).key);
    EXPECT_EQ(store.saved_trials(0), 3u);
}

TEST_F(StoreFile, KeepsTheTextOfThePublishedTables) {
    StudySpec spec = store_plan().spec;
    spec.published = Published{"t.json", std::string(published_tables)};
    Store::create_or_resume(file(), plan_study(spec));
    EXPECT_EQ(Store::open(file()).plan().spec.published, spec.published);
}

TEST_F(StoreFile, IsRefusedForAnotherStudyWithTheDifference) {
    Store::create_or_resume(file(), store_plan());
    EXPECT_EQ(refusal_to_resume(store_plan()), "nothing thrown");
    EXPECT_THAT(refusal_to_resume(store_plan("trials = 4")),
                HasSubstr("holds another study (differs in [study]: 'trials = 3' there, "
                          "'trials = 4' here)"));
    EXPECT_THAT(refusal_to_resume(store_plan("trials = 3\nlevel = 0.9")),
                HasSubstr("'level = 0.95' there, 'level = 0.9' here"));
    StudySpec seed = store_plan().spec;
    seed.seed = Seed{8};
    EXPECT_THAT(refusal_to_resume(plan_study(seed)), HasSubstr("'seed = 7' there, 'seed = 8' here"));
    StudySpec longer = store_plan().spec;
    Method& exact = longer.methods.emplace_back();
    exact.name = "exact";
    exact.estimator = "closed_form";
    exact.sizes.emplace_back();
    EXPECT_THAT(refusal_to_resume(plan_study(longer)), HasSubstr("[[method]] \"exact\": no 'name' there"));
    EXPECT_THAT(refusal_to_resume(plan_study(longer)), HasSubstr("Choose another --out"));
}

TEST_F(StoreFile, IsRefusedForOtherPublishedTables) {
    StudySpec spec = store_plan().spec;
    spec.published = Published{"t.json", std::string(published_tables)};
    Store::create_or_resume(file(), plan_study(spec));
    spec.published->text += "\n";
    EXPECT_THAT(refusal_to_resume(plan_study(spec)), HasSubstr("differs in the published tables"));
}

TEST_F(StoreFile, CannotBeOpenedIfMissing) {
    EXPECT_THAT(refusal_to_open<IoError>(), HasSubstr("no such file. Give a folder or file written by ffstudy."));
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(StoreFile, CannotBeMadeInAMissingFolder) {
    EXPECT_THAT(message_of<IoError>([&] { Store::create_or_resume(folder.path() / "none" / "s", store_plan()); }),
                HasSubstr("Check that the folder exists"));
}

TEST_F(StoreFile, IsRefusedAndLeftAloneIfNotADatabase) {
    std::ofstream(file()) << "not a database, but longer than the sixteen bytes of the magic number";
    EXPECT_THAT(refusal_to_open<UserError>(), HasSubstr("not a result store"));
    EXPECT_THAT(message_of<UserError>([&] { Store::create_or_resume(file(), store_plan()); }),
                HasSubstr("not a result store"));
    std::ifstream in(file());
    std::string word;
    in >> word;
    EXPECT_EQ(word, "not");
}

TEST_F(StoreFile, IsRefusedAndLeftAloneIfOfAnotherProgram) {
    execute("CREATE TABLE mine(a)");
    EXPECT_THAT(refusal_to_open<UserError>(), HasSubstr("not a result store (no table 'meta')"));
    EXPECT_THAT(refusal_to_resume(store_plan()), HasSubstr("not a result store (no table 'meta')"));
}

TEST_F(StoreFile, IsRefusedIfOfANewerVersion) {
    Store::create_or_resume(file(), store_plan());
    execute("UPDATE meta SET value = '99' WHERE key = 'schema_version'");
    const std::string problem =
        "schema version 99 (this program reads 1 to 2). Use the version of ffstudy that wrote it.";
    EXPECT_THAT(refusal_to_open<UserError>(), HasSubstr(problem));
    EXPECT_THAT(refusal_to_resume(store_plan()), HasSubstr(problem));
}

TEST_F(StoreFile, IsRefusedIfDamaged) {
    test::run(store_plan("trials = 200"), file());
    // A page in the middle, where rows are.
    std::fstream bytes(file(), std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file()) / 2));
    bytes << std::string(4096, 'x');
    bytes.close();
    EXPECT_THAT(refusal_to_open<IoError>(), HasSubstr("damaged"));
    EXPECT_THAT(message_of<IoError>([&] { Store::create_or_resume(file(), store_plan("trials = 200")); }),
                HasSubstr("damaged"));
}

TEST_F(StoreFile, IsRefusedIfCutOff) {
    test::run(store_plan("trials = 200"), file());
    std::filesystem::resize_file(file(), std::filesystem::file_size(file()) / 2);
    EXPECT_NE(refusal_to_open<IoError>(), "nothing thrown");
}

TEST_F(StoreFile, IgnoresTheLogOfAnotherStore) {
    const auto log = [](const std::filesystem::path& store) { return store.string() + "-wal"; };
    const auto other = folder.path() / "other.sqlite";
    const auto bytes = [&] {
        std::ifstream in(file(), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    {
        Store closed = Store::create_or_resume(file(), store_plan(), Journal::write_ahead);
        run_study(closed, {});
    }
    const std::string before = bytes();
    {
        Store open = Store::create_or_resume(other, store_plan("trials = 4"), Journal::write_ahead);
        open.commit({0, {}, {}, {}});
        std::filesystem::copy_file(log(other), log(file()));
    }
    EXPECT_ANY_THROW(Store::create_or_resume(file(), store_plan(), Journal::write_ahead));
    EXPECT_EQ(bytes(), before);
    std::filesystem::remove(log(file()));
    EXPECT_TRUE(Store::create_or_resume(file(), store_plan()).is_complete());
}

TEST_F(StoreFile, HasNoLogOnceSealed) {
    const std::string log = file().string() + "-wal";
    {
        // The content of a copy of the folder that was made while the study ran.
        Store store = Store::create_or_resume(file(), store_plan("trials = 400"), Journal::write_ahead);
        store.commit({0, {}, {}, {}});
        std::filesystem::copy_file(log, folder.path() / "log");
    }
    std::filesystem::remove(file());
    test::run(store_plan("trials = 400"), file()).seal();
    std::filesystem::copy_file(folder.path() / "log", log);
    EXPECT_THAT(refusal_to_open<IoError>(), HasSubstr("results.sqlite-wal: a log beside a file that was made whole"));
    EXPECT_THAT(message_of<IoError>([&] { Store::create_or_resume(file(), store_plan("trials = 400")); }),
                HasSubstr("Remove the log"));
    std::filesystem::remove(log);
    EXPECT_EQ(Store::open(file()).saved_trials(0), 400u);
}

TEST_F(StoreFile, IsMadeOnceWhenTwoProgramsBeginTogether) {
    for (int round = 0; round < 20; ++round) {
        std::filesystem::remove(file());
        std::barrier together(2);
        std::array<std::string, 2> problems;
        {
            std::vector<std::jthread> threads;
            for (std::string& problem : problems) {
                threads.emplace_back([&] {
                    together.arrive_and_wait();
                    problem = message_of<std::exception>([&] { Store::create_or_resume(file(), store_plan()); });
                });
            }
        }
        EXPECT_THAT(problems, testing::Each("nothing thrown"));
    }
}

TEST_F(StoreFile, KeepsItsLogWhileAnotherProgramReadsIt) {
    Store store = Store::create_or_resume(file(), store_plan(), Journal::write_ahead);
    run_study(store, {});
    {
        const Database reader(file(), Database::Mode::read_only);
        Statement units(reader.handle(), "SELECT unit FROM units");
        ASSERT_TRUE(units.step());
        EXPECT_FALSE(store.seal());
        EXPECT_EQ(store.saved_trials(0), 3u);
    }
    EXPECT_TRUE(store.seal());
    EXPECT_EQ(journal_mode(store), "delete");
}

TEST_F(StoreFile, IsFoundByAnyValidFileName) {
    EXPECT_EQ(sqlite_name("file:x?mode=memory"), (std::filesystem::current_path() / "file:x?mode=memory").string());
    EXPECT_THAT(message_of<IoError>([] { sqlite_name(std::filesystem::path("/") / std::string(600, 'a')); }),
                HasSubstr("a path of 601 bytes is too long for SQLite"));
}

TEST_F(StoreFile, IsTheSameWithARollbackJournal) {
    for (const auto journal : {Journal::write_ahead, Journal::rollback}) {
        const auto name = folder.path() / (journal == Journal::rollback ? "rollback" : "log");
        Store store = Store::create_or_resume(name, store_plan(), journal);
        EXPECT_EQ(journal_mode(store), journal == Journal::rollback ? "delete" : "wal");
        run_study(store, {});
        EXPECT_EQ(store.saved_trials(0), 3u);
    }
    EXPECT_EQ(test::rows_of(folder.path() / "rollback"), test::rows_of(folder.path() / "log"));
}

TEST_F(StoreFile, SwitchesToTheJournalOfItsNewFolder) {
    Store::create_or_resume(file(), store_plan(), Journal::write_ahead).commit({0, {}, {}, {}});
    execute("DELETE FROM units");
    Store store = Store::create_or_resume(file(), store_plan(), Journal::rollback);
    EXPECT_EQ(journal_mode(store), "delete");
}

TEST_F(StoreFile, NoticesThatItIsMovedOrRemovedDuringWriting) {
    Store moved = Store::create_or_resume(file(), store_plan());
    std::filesystem::rename(file(), folder.path() / "elsewhere");
    EXPECT_THAT(message_of<IoError>([&] { moved.commit({0, {}, {}, {}}); }), HasSubstr("moved or removed"));
    EXPECT_EQ(Store::open(folder.path() / "elsewhere").saved_trials(0), 0u);
}

TEST_F(StoreFile, BecomesAStoreIfEmpty) {
    std::ofstream(file()).flush();
    EXPECT_EQ(test::run(store_plan(), file()).saved_trials(0), 3u);
}

UnitRecord record_with(std::int64_t hits) {
    return {0, {{observable::hits, 1, 2, 0, hits}, {observable::hits, 1, 2, 1, hits + 1}}, {1, 2}, {3, 1ULL << 63}};
}

TEST_F(StoreFile, ReportsThatItCannotGrow) {
    Store store = Store::create_or_resume(file(), store_plan());
    store.set_context({{"a", "b"}});  // now there is a log, and only the end of a transaction has to grow it
    {
        const test::FullDisk full;
        EXPECT_THAT(message_of<IoError>([&] { store.commit(record_with(10)); }), HasSubstr("results.sqlite"));
    }
    EXPECT_EQ(Store::open(file()).saved_trials(0), 0u);
}

TEST(Store, CommittingAUnitAgainChangesNothing) {
    Store store = Store::create_or_resume(in_memory, store_plan());
    store.commit(record_with(10));
    store.commit(record_with(20));
    EXPECT_THAT(store.series(0, observable::hits, 1, 2).value, testing::ElementsAre(10, 11));
    EXPECT_EQ(store.saved_trials(0), 3u);
}

TEST(Store, ListsFinishedUnits) {
    Store store = Store::create_or_resume(in_memory, store_plan());
    EXPECT_THAT(store.finished_units(), testing::ElementsAre(false));
    EXPECT_EQ(store.saved_trials(0), 0u);
    store.commit(record_with(10));
    EXPECT_THAT(store.finished_units(), testing::ElementsAre(true));
}

TEST(Store, SavesNothingOfAUnitThatFails) {
    Store store = Store::create_or_resume(in_memory, store_plan());
    EXPECT_ANY_THROW(store.commit({99, {}, {}, {}}));
    store.commit(record_with(10));
    EXPECT_THAT(store.series(0, observable::hits, 1, 2).value, testing::ElementsAre(10, 11));
}

TEST(Store, ReplacesItsContextAsAWhole) {
    Store store = Store::create_or_resume(in_memory, store_plan());
    store.set_context({{"host", "a"}, {"threads", "2"}});
    store.set_context({{"host", "b"}});
    EXPECT_EQ(store.context(), (Context{{"host", "b"}}));
}

TEST(Store, SumsPatchHitsOverTheTrialsOfAUnit) {
    test::TemporaryFolder folder;
    const auto file = folder.path() / "results.sqlite";
    const Store store = test::run(store_plan(), file);
    const Database database(file, Database::Mode::read_only);
    Statement units(database.handle(), "SELECT patch_hits FROM units");
    ASSERT_TRUE(units.step());
    const auto hits = units.integers(0);
    ASSERT_EQ(hits.size(), 24u * 6u);  // 4 patches on each of 6 faces
    std::uint64_t from_1_to_2 = 0;
    for (std::size_t patch = 0; patch < 4; ++patch) from_1_to_2 += hits[patch * 6 + 1];
    EXPECT_EQ(from_1_to_2, static_cast<std::uint64_t>(store.total(0, observable::hits, 1, 2)));
}

}  // namespace
}  // namespace ff::studies
