#include "studies/verdicts/history.hpp"

#include "core/support/error.hpp"
#include "stats/moments.hpp"
#include "studies/readers/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace ff::studies {
namespace {

constexpr std::string_view history_header = "commit,quantity,mean,standard_error,n,cost";

double number_of(const CsvReader& reader, const CsvField& field) {
    double number = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [stop, error] = std::from_chars(field.text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number))
        reader.fail(field, "not a finite number. Restore the history, or remove the line.");
    return number;
}

/// As a cell of CSV.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char letter : text) cell += letter == '"' ? "\"\"" : std::string(1, letter);
    return cell + "\"";
}

}  // namespace

std::optional<double> HistoryRow::spread() const {
    if (n <= 0) return std::nullopt;
    return standard_error * std::sqrt(n);
}

History parse_history(std::string_view text, std::string_view origin) {
    enum Column : std::size_t { commit, quantity, mean, standard_error, n, cost, columns };
    CsvReader reader(text, origin);
    std::vector<CsvField> record;
    History history;
    bool headed = false;
    while (reader.next(record)) {
        if (record.size() != columns || (!headed && record[commit].text != "commit"))
            reader.fail(record.front(),
                        fmt::format("not a line of a history (it begins with the line {}). Restore it, or begin a new "
                                    "one by 'ffstudy check --history'.",
                                    history_header));
        if (!headed) {
            headed = true;
            continue;
        }
        HistoryRow row{.commit = record[commit].text, .quantity = record[quantity].text, .cost = {}};
        row.mean = number_of(reader, record[mean]);
        row.standard_error = number_of(reader, record[standard_error]);
        if (row.standard_error < 0)
            reader.fail(record[standard_error], "an error cannot be negative. Remove the line.");
        if (!record[n].text.empty()) row.n = number_of(reader, record[n]);
        if (!record[cost].text.empty()) row.cost = number_of(reader, record[cost]);
        history.push_back(std::move(row));
    }
    return history;
}

std::string history_csv(const History& history) {
    std::string text = fmt::format("{}\n", history_header);
    for (const HistoryRow& row : history)
        text +=
            fmt::format("{},{},{},{},{},{}\n", quoted(row.commit), quoted(row.quantity), row.mean, row.standard_error,
                        row.n > 0 ? fmt::format("{}", row.n) : "", row.cost ? fmt::format("{}", *row.cost) : "");
    return text;
}

History summarise(const EstimatesFile& file, const std::string& name) {
    History rows;
    for (const EstimateSeries& series : file.series) {
        const auto moments = stats::moments_of(series.values, series.values.front());
        rows.push_back({.commit = name,
                        .quantity = series.quantity,
                        .mean = series.values.front() + *moments.bias(),
                        .standard_error = *moments.standard_error(),
                        .n = static_cast<double>(series.values.size()),
                        .cost = {}});
    }
    return rows;
}

History summarise(const ReportedFile& file, const std::string& name, std::vector<std::string>& left_out) {
    History rows;
    for (std::size_t q = 0; q < file.quantities.size(); ++q) {
        if (file.rows[q].size() != 1 || file.holds != Holds::means) {
            left_out.push_back(file.quantities[q]);
            continue;
        }
        const ReportedRow& row = file.rows[q].front();
        rows.push_back({.commit = name,
                        .quantity = file.quantities[q],
                        .mean = row.mean,
                        .standard_error = row.standard_error,
                        .n = row.n,
                        .cost = file.has_cost ? std::optional(row.cost) : std::nullopt});
    }
    return rows;
}

bool has_commit(const History& history, std::string_view name) {
    return std::any_of(history.begin(), history.end(), [&](const HistoryRow& row) { return row.commit == name; });
}

}  // namespace ff::studies
