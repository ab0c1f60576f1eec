#include "reports/files/output_file.hpp"

#include "core/support/error.hpp"
#include "tests/support/full_disk.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ff::reports {
namespace {

class WriteFile : public testing::Test {
  protected:
    std::string content() const {
        std::ifstream in(file);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
    }
    test::TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "report.md";
};

TEST_F(WriteFile, ReplacesTheWholeFile) {
    write_file(file, "a longer text");
    write_file(file, "short");
    EXPECT_EQ(content(), "short");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, LeavesTheOldFileWhereTheWriterFails) {
    write_file(file, "old");
    EXPECT_THROW(write_file(file,
                            [](std::ostream& out) {
                                out << "half";
                                throw std::runtime_error("disk on fire");
                            }),
                 std::runtime_error);
    EXPECT_EQ(content(), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, FailsWithTheNameAndTheReason) {
    try {
        write_file(folder.path() / "none" / "report.md", "text");
        FAIL() << "written";
    } catch (const IoError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("none/report.md"));
        EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
    }
}

TEST_F(WriteFile, FailsWhenTheStreamFails) {
    EXPECT_THROW(write_file(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }), IoError);
    EXPECT_EQ(files(), 0u);
}

TEST_F(WriteFile, ReportsTheFirstFailure) {
    const test::FullDisk full;
    try {
        write_file(file, [](std::ostream& out) {
            out << std::string(1 << 20, 'x');  // more than is kept before it is written
            EXPECT_FALSE(std::filesystem::exists("/no/such/file"));
            errno = ENOENT;
        });
        FAIL() << "written";
    } catch (const IoError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("report.md: cannot be written (File too large)"));
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(WriteFile, DoesNotDisturbOthersThatWriteTheSameFile) {
    std::ofstream(file.string() + ".part") << "the user's own";
    write_file(file, [&](std::ostream& out) {
        out << "outer";
        write_file(file, "inner");
        EXPECT_EQ(content(), "inner");
        out << " text";
    });
    EXPECT_EQ(content(), "outer text");
    EXPECT_EQ(files(), 2u);
}

TEST_F(WriteFile, FailsWhereAFolderIsInTheWay) {
    std::filesystem::create_directory(file);
    EXPECT_ANY_THROW(write_file(file, "text"));
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace ff::reports
