#include "studies/verdicts/reported/estimates_file.hpp"

#include "core/support/error.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace ff::studies::gates {
namespace {

constexpr std::array<std::string_view, 3> estimate_columns{"trial", "quantity", "estimate"};

/// Position of each column in a record.
using EstimateHeader = std::array<std::size_t, estimate_columns.size()>;

struct Row {
    std::uint64_t trial = 0;
    double value = 0;
    std::size_t line = 0;
};
using RowsByQuantity = std::map<std::string, std::vector<Row>>;

EstimateHeader read_estimate_header(CsvReader& reader, std::string_view origin) {
    std::vector<CsvField> record;
    if (!reader.next(record))
        throw UserError("{}:1:1: the file is empty (no estimates). Begin it with the line {}.", origin,
                        fmt::join(estimate_columns, ","));
    const auto found = find_columns(reader, record, estimate_columns);
    EstimateHeader header{};
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i])
            reader.fail(record.front(), fmt::format("column '{}' is missing (the columns are {}). Add it.",
                                                    estimate_columns[i], fmt::join(estimate_columns, ", ")));
        header[i] = *found[i];
    }
    return header;
}

Row read_row(const CsvReader& reader, const std::vector<CsvField>& record, const EstimateHeader& header) {
    const auto [trial, quantity, estimate] = header;
    return {.trial = read_index(reader, record[trial], "trial"),
            .value = read_magnitude(reader, record[estimate], "estimate",
                                    "a mean of it would mean nothing). Find out why the program gave it."),
            .line = record.front().line};
}

RowsByQuantity read_rows(CsvReader& reader, const EstimateHeader& header) {
    RowsByQuantity rows;
    std::vector<CsvField> record;
    while (reader.next(record)) {
        if (record.size() != header.size())
            reader.fail(record.front(),
                        fmt::format("{} cell(s) (there are {} columns). Numbers have a decimal point, and "
                                    "cells with commas stand in quotes.",
                                    record.size(), header.size()));
        rows[std::string(reader.filled(record[header[1]], "quantity"))].push_back(read_row(reader, record, header));
    }
    return rows;
}

EstimateSeries make_series(const std::string& quantity, std::vector<Row> rows, std::string_view origin) {
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return std::tie(a.trial, a.line) < std::tie(b.trial, b.line); });
    EstimateSeries series{.quantity = quantity, .values = {}, .lines = {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i > 0 && rows[i].trial == rows[i - 1].trial)
            throw UserError(
                "{}:{}:1: trial {} gives '{}' again (line {} has it already; counted twice, it "
                "would look like more trials than there were). Remove one.",
                origin, rows[i].line, rows[i].trial, quantity, rows[i - 1].line);
        series.values.push_back(rows[i].value);
        series.lines.push_back(rows[i].line);
    }
    if (rows.size() < fewest_estimates)
        throw UserError(
            "{}:{}:1: '{}' has {} row(s) (spread and independence cannot be judged below {} "
            "trials). Run more trials; 50 to 200 are usual.",
            origin, rows.back().line, quantity, rows.size(), fewest_estimates);
    return series;
}

}  // namespace

EstimatesFile parse_estimates(std::string_view text, std::string_view origin) {
    CsvReader reader(text, origin);
    const EstimateHeader header = read_estimate_header(reader, origin);
    EstimatesFile file{.origin = std::string(origin), .series = {}};
    for (auto& [name, rows] : read_rows(reader, header))
        file.series.push_back(make_series(name, std::move(rows), origin));
    if (file.series.empty())
        throw UserError("{}:1:1: no rows below the header (no estimates). Add one for each trial.", origin);
    return file;
}

EstimatesFile load_estimates_file(const std::filesystem::path& file) {
    return parse_estimates(read_text_file(file, FileKind::estimates), file.string());
}

const EstimateSeries& find_series(const EstimatesFile& file, std::string_view wanted, std::string_view place) {
    std::vector<std::string_view> names;
    for (const EstimateSeries& series : file.series) {
        if (series.quantity == wanted) return series;
        names.emplace_back(series.quantity);
    }
    fail_without(wanted, "estimates", file.origin, names, place);
}

}  // namespace ff::studies::gates
