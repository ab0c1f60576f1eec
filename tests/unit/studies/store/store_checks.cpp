#include "studies/store/store_checks.hpp"

#include "core/support/error.hpp"
#include "studies/store/store.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

using testing::HasSubstr;

/// A store of three trials of one cell, to be changed.
class StoreRows : public testing::Test {
  protected:
    void write() const {
        std::filesystem::remove(file());
        test::run(test::plan_of(test::study_text("trials = 3", R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = 4
samples_per_patch = 100
)")),
                  file());
    }
    void change(const char* sql) const { Database(file(), Database::Mode::create_or_open).execute(sql); }
    std::string refusal() const {
        return test::message_of<IoError>([&] { Store::open(file()); });
    }
    std::filesystem::path file() const { return folder.path() / "results.sqlite"; }
    test::TemporaryFolder folder;
};

TEST_F(StoreRows, AreRefusedWithUnitsOutsideTheStudy) {
    for (const char* sql : {"UPDATE units SET unit = 1", "UPDATE units SET first_trial = 1",
                            "UPDATE units SET trials = 2", "UPDATE units SET cell = -1"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("is none of this study")) << sql;
    }
}

TEST_F(StoreRows, AreRefusedWithValuesOfTrialsInNoUnit) {
    for (const char* sql : {"DELETE FROM units", "INSERT INTO observations VALUES(0, 'hits', 1, 2, 3, 100)",
                            "INSERT INTO observations VALUES(1, 'hits', 1, 2, 0, 100)"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("values of trials that no unit holds")) << sql;
    }
}

TEST_F(StoreRows, AreRefusedWithSumsForOtherPatches) {
    for (const char* sql :
         {"UPDATE units SET patch_hits = zeroblob(100000)", "UPDATE units SET patch_hits_squared = zeroblob(0)",
          "UPDATE units SET patch_hits = zeroblob(8), patch_hits_squared = zeroblob(8)"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("unit 0 has sums of another number of patches")) << sql;
    }
}

TEST_F(StoreRows, AreRefusedWithNegativeNumbersOfRays) {
    write();
    change("INSERT INTO observations VALUES(0, 'lost', 1, 0, 0, -5)");
    EXPECT_THAT(refusal(), HasSubstr("'lost' of faces 1 and 0 in cell 0 has a negative number"));
}

TEST_F(StoreRows, AreRefusedWithMoreHitsThanRays) {
    for (const char* sql :
         {"UPDATE observations SET value = 401 WHERE observable = 'hits' AND from_face = 2 AND to_face = "
          "3 AND trial = 1",
          "UPDATE observations SET value = 399 WHERE observable = 'rays' AND from_face = 2 AND trial = 1",
          "INSERT INTO observations VALUES(0, 'lost', 2, 0, 1, 1)"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(),
                    HasSubstr("of faces 2 and 0 in cell 0 has fewer rays than have hit something or were lost"))
            << sql;
    }
}

TEST_F(StoreRows, AreRefusedIfChangedSinceTheyWereSaved) {
    for (const char* sql :
         {"UPDATE observations SET value = value - 1 WHERE observable = 'hits' AND value > 0 AND trial = 2 "
          "AND from_face = 1 AND to_face = 2",
          "DELETE FROM observations WHERE observable = 'hits' AND trial = 2 AND to_face = 3",
          "UPDATE units SET patch_hits = zeroblob(length(patch_hits))", "UPDATE units SET checksum = 0",
          "UPDATE units SET checksum = NULL"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("unit 0 is not as it was saved: its checksum differs")) << sql;
    }
    for (const char* sql : {"UPDATE meta SET value = replace(value, 'seed = 7', 'seed = 8')",
                            "UPDATE cells SET trials = 4", "DELETE FROM meta WHERE key = 'checksum'"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("the study is not as it was saved")) << sql;
    }
    write();
    change("INSERT INTO context VALUES('host', 'another')");
    EXPECT_THAT(refusal(), HasSubstr("the context is not as it was saved"));
}

TEST_F(StoreRows, AreRefusedWithUnknownNamesOrFaces) {
    for (const char* sql : {"INSERT INTO observations VALUES(0, 'hitz', 1, 2, 0, 100)",
                            "INSERT INTO observations VALUES(0, 'hits', 7, 2, 0, 100)",
                            "INSERT INTO observations VALUES(0, 'hits', 1, -1, 0, 100)"}) {
        write();
        change(sql);
        EXPECT_THAT(refusal(), HasSubstr("has no such name or face")) << sql;
    }
}

}  // namespace
}  // namespace ff::studies
