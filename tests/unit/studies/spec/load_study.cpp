#include "core/support/error.hpp"
#include "studies/spec/spec.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace ff::studies {
namespace {

using test::random_rays;
using test::study_text;
using testing::HasSubstr;

class LoadStudy : public testing::Test {
  protected:
    std::filesystem::path write(std::string_view name, std::string_view text) const {
        std::ofstream(folder.path() / name) << text;
        return folder.path() / name;
    }
    std::filesystem::path study_with_tables() const {
        return write("study.toml",
                     study_text("trials = 9", std::string(random_rays) + "[published]\ntables = \"t.json\""));
    }
    test::TemporaryFolder folder;
};

TEST_F(LoadStudy, CannotReadAMissingFileOrAFolder) {
    EXPECT_THROW(static_cast<void>(load_study(folder.path() / "none.toml")), IoError);
    EXPECT_THROW(static_cast<void>(load_study(folder.path())), IoError);
}

TEST_F(LoadStudy, SaysWhatIsMissingInAnEmptyFile) {
    EXPECT_THROW(static_cast<void>(load_study(write("empty.toml", ""))), UserError);
}

TEST_F(LoadStudy, ReadsTheTablesBesideTheStudy) {
    const std::string tables = R"({"source": "s", "scene": "cube", "methods": [], "tables": []})";
    write("t.json", tables);
    EXPECT_EQ(load_study(study_with_tables()).published->text, tables);
}

TEST_F(LoadStudy, RefusesMalformedTablesBeforeAnythingIsRun) {
    write("t.json", R"({"source": "s",)");
    try {
        static_cast<void>(load_study(study_with_tables()));
        FAIL() << "accepted";
    } catch (const UserError& error) {
        EXPECT_THAT(error.what(), HasSubstr("t.json:1:"));
    }
}

}  // namespace
}  // namespace ff::studies
