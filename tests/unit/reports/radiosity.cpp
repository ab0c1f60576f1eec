#include "reports/csv/csv.hpp"
#include "reports/json/json_records.hpp"
#include "reports/markdown/markdown_sections.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/tables/tables.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/headline.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace ff::reports {
namespace {

using studies::radiosity::Between;
using studies::radiosity::Treatment;
using testing::HasSubstr;
using testing::Not;

const studies::StudyResults& lit() {
    static const studies::StudyResults made = studies::evaluate(test::run(test::plan_of(test::study_text("trials = 40",
                                                                                                         R"([radiosity]
reflectance = [0.5, 0.9, 0.99]
emission = [0, 0, 0, 0, 0, 2]
patch_trials = 2
[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
patches_per_face = 4
samples_per_patch = 100
[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = 5
estimator = "area_kernel"
patches_per_face = 4
)"))));
    return made;
}

std::string all_of(const std::vector<std::string>& lines) {
    return fmt::format("{}", fmt::join(lines, "\n"));
}

// The limit stated for dominance is 1 / the largest row sum of the estimates themselves, not a fixed sentence about
// PDM.
TEST(RadiosityWords, SayWhereDominanceIsLost) {
    const auto& plan = lit().findings.plan;
    const studies::radiosity::Consequences& pdm = *lit().radiosity->find(1, Treatment::direct);
    const std::string limit = brief(1 / (1 + pdm.closure_defect.median), 4);
    const std::string said = all_of(radiosity_in_brief(lit()));
    EXPECT_THAT(said, HasSubstr(fmt::format("PDM, 4 × 5²·5² nodes, direct: I − P F loses diagonal dominance from "
                                            "reflectance {} on",
                                            limit)));
    EXPECT_THAT(said, HasSubstr("at 0.99 the exitance is negative or undefined"));
    EXPECT_THAT(said, HasSubstr("Between the 24 patches of SR"));
    studies::StudyResults mended = lit();
    for (auto& found : mended.radiosity->consequences) found.dominant_below = {1, 1, 1};
    EXPECT_THAT(all_of(radiosity_in_brief(mended)), Not(HasSubstr("loses diagonal dominance")));
    EXPECT_THAT(all_of(radiosity_in_brief(mended)), HasSubstr("keeps diagonal dominance at every reflectance below 1"));
    EXPECT_EQ(plan.cells.size(), 2u);
}

TEST(RadiosityWords, NameThePatchThatErrsMost) {
    const auto& plan = lit().findings.plan;
    studies::radiosity::Consequences found = *lit().radiosity->find(0, Treatment::direct, Between::patches);
    EXPECT_EQ(element_text(plan, found, 1), "face 1, row 1, column 1");
    EXPECT_EQ(element_text(plan, found, 24), "face 6, row 2, column 2");
    EXPECT_EQ(element_text(plan, *lit().radiosity->find(0, Treatment::direct), 3), "face 3");
    studies::radiosity::SettingStatistics& at = found.settings.front();
    at.exitance[7].rmse = 100 * at.exitance[7].exact;
    EXPECT_EQ(worst_element(at)->element, 7u);
    EXPECT_THAT(at.exitance, testing::SizeIs(25));
}

TEST(Headline, BeginsWithTheExitanceError) {
    const auto light = light_in_brief(lit());
    ASSERT_TRUE(light);
    EXPECT_EQ(light->reflectance, "0.9");
    EXPECT_THAT(light->clause, testing::ContainsRegex(
                                   "at reflectance 0.9 with 4 patches per face the light errs by [0-9.]+ ± [0-9.]+ % "
                                   "with SR, .* % with PDM; balance the factors: at most [0-9.]+ %"));
    EXPECT_THAT(headline(lit()).verdict, testing::StartsWith("At reflectance 0.9 with 4 patches per face the "));
    // Where balancing failed in one trial, and where it is not shown to help, nothing is said of it.
    auto results = lit();
    for (auto& found : results.radiosity->consequences)
        found.not_balanced = found.treatment == Treatment::balanced ? 1 : 0;
    EXPECT_THAT(light_in_brief(results)->clause, testing::Not(testing::HasSubstr("balancing")));
    results = lit();
    for (auto& found : results.radiosity->consequences) {
        if (found.treatment != Treatment::balanced) continue;
        for (auto& at : found.settings) {
            if (at.light_interval) at.light_interval->high = 1;
        }
    }
    EXPECT_THAT(light_in_brief(results)->clause, testing::Not(testing::HasSubstr("balancing")));
    EXPECT_EQ(headline(lit()).numbers.front().value, light->value);
    EXPECT_FALSE(light_in_brief(test::small_results()));
}

TEST(RadiosityTables, CoverFacesAndPatches) {
    std::set<std::string> ids;
    for (const Table& table : radiosity_tables(lit())) {
        EXPECT_TRUE(ids.insert(table.id).second) << table.id;
        EXPECT_FALSE(table.rows.empty()) << table.id;
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.id;
    }
    for (const char* id : {"radiosity-matrices", "radiosity-exitance", "radiosity-solvers"}) {
        EXPECT_TRUE(ids.contains(id));
        EXPECT_TRUE(ids.contains(std::string(id) + "-patches"));
    }
    EXPECT_TRUE(radiosity_tables(test::small_results()).empty());
    EXPECT_THAT(radiosity_section(lit()), HasSubstr("Exitance errors, between patches"));
}

/// The rows of a table as fields; the first is the header.
template <typename Write>
std::vector<std::vector<std::string>> rows_of(Write write) {
    std::ostringstream out;
    write(out, lit());
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : test::lines_of(out.str())) rows.push_back(test::csv_fields(line));
    return rows;
}

TEST(RadiosityCsv, HasAsManyFieldsAsColumnsInEveryRow) {
    for (const auto write :
         {write_matrices_csv, write_systems_csv, write_exitance_csv, write_solvers_csv, write_residuals_csv}) {
        const auto rows = rows_of(write);
        ASSERT_GT(rows.size(), 2u);
        std::set<std::string> between;
        for (const auto& row : rows) {
            EXPECT_EQ(row.size(), rows.front().size()) << fmt::format("{}", fmt::join(row, ","));
            between.insert(row.at(5));
        }
        EXPECT_EQ(between, (std::set<std::string>{"between", "faces", "patches"}));
    }
}

// Every patch once for each treatment and setting, with the place that PatchOrder gives it.
TEST(RadiosityCsv, NamesEveryPatch) {
    const auto rows = rows_of(write_exitance_csv);
    std::map<std::string, int> seen;
    for (const auto& row : rows) {
        if (row[5] == "patches") ++seen[fmt::format("{},{},{}", row[9], row[10], row[11])];
    }
    EXPECT_EQ(seen.size(), 25u);  // 24 patches, and all together
    for (const auto& [place, times] : seen) EXPECT_EQ(times, 2 * 4 * 3) << place;
}

TEST(RadiosityJson, HasTheWorstPatch) {
    const auto document = radiosity_json(lit());
    std::size_t patches = 0;
    for (const auto& found : document.at("consequences")) {
        if (found.at("between") != "patches") continue;
        ++patches;
        for (const auto& at : found.at("settings")) {
            EXPECT_LE(at.at("exitance").size(), 2u);
            if (at.at("exitance").size() == 2u) {
                EXPECT_TRUE(at.at("exitance")[1].at("row").is_number());
            }
        }
    }
    EXPECT_EQ(patches, 2u * 4);
}

TEST(RadiosityPictures, ShowTheLightOnThePatchesAndWhereItErrs) {
    const auto group = radiosity_pictures(lit());
    ASSERT_TRUE(group);
    std::set<std::string> kinds;
    for (const Picture& picture : group->pictures) {
        kinds.insert(picture.kind);
        const auto values = nlohmann::json::parse(picture.values);
        EXPECT_FALSE(picture.finding.empty()) << picture.kind;
        if (!values.contains("choose")) continue;
        // Exactly the existing choices are offered.
        const auto& columns = values.at("columns");
        const auto column = std::find(columns.begin(), columns.end(), values.at("choose").at("signal"));
        ASSERT_NE(column, columns.end()) << picture.kind;
        std::set<std::string> chosen, there;
        for (const auto& value : values.at("choose").at("values")) chosen.insert(value);
        for (const auto& row : values.at("rows")) {
            const auto& name = row.at(static_cast<std::size_t>(column - columns.begin()));
            if (name.is_string()) there.insert(name);
        }
        EXPECT_EQ(chosen, there) << picture.kind;
    }
    EXPECT_EQ(kinds,
              (std::set<std::string>{"light_errors", "spectral_radius", "residuals", "exitance", "exitance_errors"}));
    EXPECT_FALSE(radiosity_pictures(test::small_results()));
}

// Emission 2: the picture is in units of the emission.
TEST(RadiosityPictures, AreInUnitsOfTheEmission) {
    for (const Picture& picture : exitance_pictures(lit(), 0)) {
        if (picture.kind != "exitance") continue;
        EXPECT_THAT(picture.finding, testing::ContainsRegex("to 1\\.[0-9]+ times the emission"));
    }
}

}  // namespace
}  // namespace ff::reports
