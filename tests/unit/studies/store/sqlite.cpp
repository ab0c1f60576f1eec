#include "studies/store/sqlite.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>

namespace ff::studies {
namespace {

/// A file with one row, as it is left by a program that is killed while it writes a thousand more.
std::filesystem::path killed_while_writing(const std::filesystem::path& folder) {
    const auto file = folder / "store.sqlite";
    Database writer(file, Database::Mode::create_or_open);
    writer.execute("PRAGMA journal_mode = DELETE; CREATE TABLE t (x BLOB); INSERT INTO t VALUES (zeroblob(10));");
    writer.execute(
        "BEGIN IMMEDIATE; WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000) "
        "INSERT INTO t SELECT zeroblob(1000) FROM n;");
    sqlite3_db_cacheflush(writer.handle());
    auto left = folder / "left.sqlite";
    std::filesystem::copy_file(file, left);
    std::filesystem::copy_file(folder / "store.sqlite-journal", folder / "left.sqlite-journal");
    writer.execute("ROLLBACK");
    return left;
}

TEST(Database, IsReadAsBeforeAnInterruptedWrite) {
    const test::TemporaryFolder folder;
    const Database reader(killed_while_writing(folder.path()), Database::Mode::read_only);
    Statement rows(reader.handle(), "SELECT count(*) FROM t");
    ASSERT_TRUE(rows.step());
    EXPECT_EQ(rows.integer(0), 1);
}

TEST(Database, StaysReadOnlyAfterAnInterruptedWrite) {
    const test::TemporaryFolder folder;
    const Database reader(killed_while_writing(folder.path()), Database::Mode::read_only);
    EXPECT_THROW(reader.execute("INSERT INTO t VALUES (1)"), IoError);
}

}  // namespace
}  // namespace ff::studies
