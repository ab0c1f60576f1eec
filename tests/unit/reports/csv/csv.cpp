#include "reports/csv/csv.hpp"
#include "reports/csv/csv_records.hpp"

#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace ff::reports {
namespace {

using test::csv_fields;
using test::lines_of;

/// Column names, and the values of a row by name.
struct CsvTable {
    std::vector<std::string> header;
    std::vector<std::map<std::string, std::string>> rows;
};

CsvTable parse_csv(const std::string& text) {
    CsvTable table;
    for (const std::string& line : lines_of(text)) {
        const auto fields = csv_fields(line);
        if (table.header.empty()) {
            table.header = fields;
            continue;
        }
        EXPECT_EQ(fields.size(), table.header.size()) << line;
        auto& row = table.rows.emplace_back();
        for (std::size_t i = 0; i < std::min(fields.size(), table.header.size()); ++i) row[table.header[i]] = fields[i];
    }
    return table;
}

std::string summary_text() {
    std::ostringstream out;
    write_summary_csv(out, test::small_results().findings);
    return out.str();
}

CsvTable summary() {
    return parse_csv(summary_text());
}

CsvTable trials() {
    std::ostringstream out;
    write_trials_csv(out, test::small_store());
    return parse_csv(out.str());
}

TEST(CsvRecords, HaveTheirColumnsInOrderAndNothingWhereAValueIsNull) {
    std::ostringstream out;
    CsvRecords csv(out, "b,a,low=interval/low,list,flag");
    csv.add({{"a", 1}, {"b", "x, \"y\""}, {"interval", {{"low", 0.1}}}, {"list", {0.5, 1.0}}, {"flag", true}});
    csv.add({{"a", 2}, {"b", nullptr}, {"interval", nullptr}, {"list", nullptr}, {"flag", false}});
    EXPECT_EQ(out.str(), "b,a,low,list,flag\n\"x, \"\"y\"\"\",1,0.1,0.5;1,true\n,2,,,false\n");
}

TEST(CsvRecords, RefuseARecordWithoutAColumn) {
    std::ostringstream out;
    CsvRecords csv(out, "a,low=interval/low");
    EXPECT_THROW(csv.add({{"a", 1}}), Json::out_of_range);
    EXPECT_THROW(csv.add({{"a", 1}, {"interval", {{"high", 1}}}}), Json::out_of_range);
}

TEST(SummaryCsv, HasTheDocumentedColumnsInOrder) {
    EXPECT_EQ(lines_of(summary_text()).front(),
              "study,scene,method,sampler,estimator,completion,nodes,allocation,patches_per_face,samples_per_patch,"
              "trials,from_face,to_face,pair_class,reference,mean,bias,bias_se,bias_ci_low,bias_ci_high,"
              "interval_method,level,minimum_detectable_bias,std,std_ci_low,std_ci_high,rmse,median_abs_error,"
              "relative_error_percent,skewness,excess_kurtosis,min,q05,median,q95,max,normality_p,vov,tail_index,"
              "efficiency_samples,lost_rays,std_interval_method,mean_ci_low,mean_ci_high");
}

TEST(SlopesCsv, HasTheDocumentedColumnsInOrder) {
    std::ostringstream out;
    write_slopes_csv(out, test::small_results());
    EXPECT_EQ(out.str(),
              "study,scene,method,pair_class,from_face,to_face,statistic,slope,slope_ci_low,slope_ci_high,"
              "expected,lack_of_fit_p,points\n");
}

TEST(SummaryCsv, HasARowForEveryQuantityOfEveryCell) {
    // 7 cells on each of 2 scenes; 30 pairs, 6 sums and their error.
    EXPECT_EQ(summary().rows.size(), 2u * 7 * 37);
}

TEST(SummaryCsv, QuotesTextsSoThatTheyReadBack) {
    EXPECT_EQ(summary().rows.front().at("study"), "small, with a comma");
    EXPECT_EQ(summary().rows.front().at("method"), "SR \"quoted\"");
}

TEST(SummaryCsv, HoldsOnlyFiniteNumbersOrNothing) {
    const std::vector<std::string> texts{
        "study",     "scene",   "method",     "sampler", "estimator",       "completion",         "allocation",
        "from_face", "to_face", "pair_class", "nodes",   "interval_method", "std_interval_method"};
    for (const auto& row : summary().rows) {
        for (const auto& [column, value] : row) {
            if (std::find(texts.begin(), texts.end(), column) != texts.end() || value.empty()) continue;
            std::size_t read = 0;
            const double number = std::stod(value, &read);
            EXPECT_EQ(read, value.size()) << column << " = " << value;
            EXPECT_TRUE(std::isfinite(number)) << column << " = " << value;
        }
    }
}

TEST(SummaryCsv, WritesNumbersThatReadBackAsTheSameDouble) {
    const auto rows = summary().rows;
    const auto& expected = test::small_results().findings.cells.front().summaries;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(std::stod(rows[i].at("mean")), expected[i].mean);
        EXPECT_EQ(std::stod(rows[i].at("std")), expected[i].std);
    }
}

TEST(SummaryCsv, LeavesCellsOfADeterministicMethodEmpty) {
    for (const auto& row : summary().rows) {
        if (row.at("method") != "PDM" && row.at("method") != "exact") continue;
        for (const char* column :
             {"bias_se", "bias_ci_low", "bias_ci_high", "interval_method", "level", "minimum_detectable_bias", "std",
              "std_ci_low", "std_ci_high", "skewness", "normality_p", "vov", "tail_index", "efficiency_samples"}) {
            EXPECT_EQ(row.at(column), "") << column;
        }
        EXPECT_EQ(row.at("trials"), "1");
        EXPECT_NE(row.at("mean"), "");
        EXPECT_EQ(row.at("nodes"), row.at("method") == "PDM" ? "2x3" : "");
        EXPECT_EQ(row.at("samples_per_patch"), row.at("method") == "PDM" ? "36" : "");
    }
}

TEST(SummaryCsv, LeavesIntervalsUnderInfiniteVarianceEmptyAndKeepsQuantiles) {
    std::size_t infinite = 0;
    for (const auto& row : summary().rows) {
        if (row.at("method") != "kernel" || row.at("pair_class") != "adjacent") continue;
        ++infinite;
        for (const char* column : {"bias_se", "bias_ci_low", "bias_ci_high", "minimum_detectable_bias", "std_ci_low",
                                   "std_ci_high", "efficiency_samples", "interval_method"}) {
            EXPECT_EQ(row.at(column), "") << column;
        }
        for (const char* column : {"mean", "bias", "median", "q05", "max", "median_abs_error"}) {
            EXPECT_NE(row.at(column), "") << column;
        }
    }
    EXPECT_EQ(infinite, 2u * 24);
}

TEST(SummaryCsv, GivesTheMeanAnIntervalWithoutAnExactValueToo) {
    std::size_t without = 0;
    for (const auto& row : summary().rows) {
        if (row.at("method") != "SR \"quoted\"" || row.at("mean_ci_low").empty()) continue;
        EXPECT_LT(std::stod(row.at("mean_ci_low")), std::stod(row.at("mean")));
        EXPECT_LT(std::stod(row.at("mean")), std::stod(row.at("mean_ci_high")));
        if (row.at("reference").empty())
            ++without;
        else
            EXPECT_NEAR(std::stod(row.at("mean_ci_low")) - std::stod(row.at("reference")),
                        std::stod(row.at("bias_ci_low")), 1e-12);
    }
    EXPECT_GT(without, 0u);
}

TEST(SummaryCsv, NamesSumsAndTheirError) {
    std::map<std::string, int> targets;
    for (const auto& row : summary().rows) ++targets[row.at("to_face")];
    EXPECT_EQ(targets["sum"], 2 * 7 * 6);
    EXPECT_EQ(targets["sum_re"], 2 * 7);
}

TEST(SummaryCsv, LeavesNoFaceEmptySoThatLabelsStayText) {
    for (const auto& row : summary().rows) {
        EXPECT_NE(row.at("from_face"), "");
        EXPECT_EQ(row.at("from_face") == "all", row.at("to_face") == "sum_re");
    }
}

TEST(SummaryCsv, NamesTheMethodOfEveryIntervalOfASpread) {
    std::size_t intervals = 0;
    for (const auto& row : summary().rows) {
        EXPECT_EQ(row.at("std_ci_low").empty(), row.at("std_interval_method").empty());
        intervals += row.at("std_interval_method") == "chi_squared" ? 1u : 0u;
    }
    EXPECT_GT(intervals, 0u);
}

TEST(TrialsCsv, HasTheDocumentedColumnsInOrder) {
    EXPECT_THAT(trials().header,
                testing::ElementsAre("study", "scene", "method", "patches_per_face", "samples_per_patch", "trial",
                                     "from_face", "to_face", "estimate"));
}

TEST(TrialsCsv, HasEveryDirectEstimateOfEveryTrialOnce) {
    // On each of 2 scenes 4 sampled cells of 8 trials and 3 deterministic ones of 1.
    std::vector<std::string> seen;
    for (const auto& row : trials().rows) {
        seen.push_back(row.at("scene") + row.at("method") + row.at("patches_per_face") + row.at("trial") +
                       row.at("from_face") + row.at("to_face"));
    }
    EXPECT_EQ(seen.size(), 2u * 30 * (4 * 8 + 3));
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
}

TEST(TrialsCsv, AgreesWithTheSummary) {
    double sum = 0;
    for (const auto& row : trials().rows) {
        if (row.at("scene") == "cube" && row.at("method") == "direct" && row.at("from_face") == "1" &&
            row.at("to_face") == "6") {
            sum += std::stod(row.at("estimate"));
        }
    }
    for (const auto& row : summary().rows) {
        if (row.at("scene") == "cube" && row.at("method") == "direct" && row.at("from_face") == "1" &&
            row.at("to_face") == "6") {
            EXPECT_NEAR(std::stod(row.at("mean")), sum / 8, 1e-15);
        }
    }
}

TEST(Csv, IsTheSameEveryTime) {
    EXPECT_EQ(summary_text(), summary_text());
}

}  // namespace
}  // namespace ff::reports
