#include "studies/verdicts/reported/reported_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace ff::studies::gates {
namespace {

/// Places in `reported_columns`, with names too short for the whole namespace.
struct ReportedColumns {
    enum Column : std::size_t { quantity, mean, standard_error, n, cost, bin, run, count, share, hits };
};
using ReportedColumn = ReportedColumns::Column;
constexpr std::array<std::string_view, 10> reported_columns{"quantity", "mean", "standard_error", "n",     "cost",
                                                            "bin",      "run",  "count",          "share", "hits"};
constexpr std::array<ReportedColumn, 4> value_columns{
    ReportedColumn::mean, ReportedColumn::count, ReportedColumn::share, ReportedColumn::hits};  // in the order of Holds

/// Position of each column in a record.
using ReportedHeader = std::vector<std::optional<std::size_t>>;

/// Determined by the columns that are present; means where there are none of these.
Holds held(const ReportedHeader& header) {
    if (header[ReportedColumn::hits]) return Holds::hits;
    if (header[ReportedColumn::count]) return Holds::counts;
    return header[ReportedColumn::share] ? Holds::shares : Holds::means;
}

ReportedHeader read_reported_header(CsvReader& reader, std::string_view origin, StandardErrors errors) {
    using enum ReportedColumns::Column;
    std::vector<CsvField> record;
    if (!reader.next(record))
        throw UserError(
            "{}:1:1: the file is empty (nothing would be compared). Begin it with the line "
            "quantity,mean,standard_error.",
            origin);
    ReportedHeader header = find_columns(reader, record, reported_columns);
    const ReportedColumn value = value_columns.at(static_cast<std::size_t>(held(header)));
    std::vector<ReportedColumn> needed{quantity, value};
    if (value == mean && errors == StandardErrors::required) needed.push_back(standard_error);
    if (value == hits) {
        needed.push_back(n);
    } else if (value != mean) {
        needed.push_back(bin);
    }
    for (const ReportedColumn other : {mean, standard_error, n, cost, count, share}) {
        const bool belongs = other == value || (value == hits && other == n);
        if (value != mean && !belongs && header[other])
            reader.fail(
                record[*header[other]],
                fmt::format("column '{}' beside '{}' ({} has quantity, {} and {}). Keep one.", reported_columns[other],
                            reported_columns[value], value == hits ? "a file of hits" : "a histogram",
                            value == hits ? "n" : "bin", reported_columns[value]));
    }
    for (const ReportedColumn column : needed) {
        if (!header[column])
            reader.fail(record.front(), fmt::format("column '{}' is missing (what a code reports has the columns "
                                                    "quantity,mean,standard_error; trials have "
                                                    "trial,quantity,estimate). Add it.",
                                                    reported_columns[column]));
    }
    return header;
}

/// @param why  the problem, a bracket, and a suggestion
[[noreturn]] void fail_at(const CsvReader& reader, const CsvField& field, std::string_view name, std::string_view why) {
    reader.fail(field, fmt::format("{} = '{}' ({}", name, excerpt(trimmed(field.text)), why));
}

/// Reads one record after the other as rows.
class RowReader {
    using enum ReportedColumns::Column;

  public:
    RowReader(const CsvReader& reader, const ReportedHeader& header) : reader_(reader), header_(header) {}

    ReportedRow read(const std::vector<CsvField>& record) const {
        ReportedRow row;
        if (record.front().line > std::numeric_limits<std::uint32_t>::max())
            reader_.fail(record.front(), "more than 4294967295 lines. Divide the file.");
        row.line = static_cast<std::uint32_t>(record.front().line);
        row.mean = read_value(record);
        if (header_[standard_error]) read_error(record, row);
        if (header_[n]) {
            row.n = number(record, n);
            if (held(header_) == Holds::hits) {
                expect_trials(record, row);
            } else if (row.n < 2) {
                fail(record, n, "a spread needs at least 2). Give the number of samples or batches");
            }
        }
        if (header_[cost]) {
            row.cost = number(record, cost);
            if (row.cost <= 0) fail(record, cost, "efficiency is 1 over it). Give a positive one");
        }
        if (header_[run]) row.run = read_index(reader_, record[*header_[run]], reported_columns[run]);
        return row;
    }

    std::string_view cell(const std::vector<CsvField>& record, ReportedColumn column) const {
        return reader_.filled(record[*header_[column]], reported_columns[column]);
    }

  private:
    double read_value(const std::vector<CsvField>& record) const {
        const Holds holds = held(header_);
        const ReportedColumn column = value_columns.at(static_cast<std::size_t>(holds));
        const double value = number(record, column);
        if (holds != Holds::means && value < 0) fail(record, column, "it cannot be negative). Give 0 or more");
        if (holds == Holds::hits && value != std::floor(value))
            fail(record, column, "not a whole number). Give the trials that hit, or a mean with its standard error");
        if (holds == Holds::counts && value != std::floor(value))
            fail(record, column,
                 "not a whole number: weighted events are not distributed like counts). Give each bin a mean with its "
                 "standard error");
        return value;
    }

    void expect_trials(const std::vector<CsvField>& record, const ReportedRow& row) const {
        constexpr double most = 0x1p53;  // whole numbers up to here are exact
        if (row.n != std::floor(row.n) || row.n < 0 || row.n > most)
            fail(record, n, "not a whole number up to 2^53). Give the number of trials");
        if (row.mean > row.n)
            fail(record, hits, fmt::format("more hits than the {:g} trials). Give each bin its own n", row.n));
    }

    void read_error(const std::vector<CsvField>& record, ReportedRow& row) const {
        row.standard_error = number(record, standard_error);
        if (row.standard_error < 0) fail(record, standard_error, "it cannot be negative). Give the error itself");
        if (row.standard_error == 0 && row.mean != 0)
            fail(record, standard_error,
                 fmt::format(
                     "beside a mean of {:g}: no spread is no evidence of precision; was there one batch only, or "
                     "one hit?). Leave the line out, merge bins, or give shares by the columns hits and n",
                     row.mean));
        if (row.standard_error != 0 && row.standard_error < smallest_magnitude)
            fail(record, standard_error, "its powers cannot be computed). Choose another unit");
    }

    double number(const std::vector<CsvField>& record, ReportedColumn column) const {
        return read_magnitude(reader_, record[*header_[column]], reported_columns[column],
                              "nothing can be compared with it). Find out why the code gave it.");
    }

    [[noreturn]] void fail(const std::vector<CsvField>& record, ReportedColumn column, std::string_view why) const {
        const CsvField& field = record[*header_[column]];
        fail_at(reader_, field, reported_columns[column], fmt::format("{}.", why));
    }

    const CsvReader& reader_;
    const ReportedHeader& header_;
};

/// Numbers names from 0 up. The last is looked at first: rows of one quantity stand together.
class Names {
  public:
    std::uint32_t index_of(std::string_view name) {
        if (last_ && all[*last_] == name) return *last_;
        const auto [found, is_new] = index_.try_emplace(std::string(name), static_cast<std::uint32_t>(all.size()));
        if (is_new) all.emplace_back(name);
        last_ = found->second;
        return *last_;
    }
    std::vector<std::string> all;

  private:
    std::unordered_map<std::string, std::uint32_t> index_;
    std::optional<std::uint32_t> last_;
};

/// Shorter names first, so that numbers stand in their order.
bool comes_before(std::string_view a, std::string_view b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
}

void sort_rows(ReportedFile& file) {
    for (std::size_t q = 0; q < file.rows.size(); ++q) {
        auto& rows = file.rows[q];
        const auto before = [&](const ReportedRow& a, const ReportedRow& b) {
            if (a.name == b.name || file.names[a.name] == file.names[b.name]) return a.run < b.run;
            return comes_before(file.names[a.name], file.names[b.name]);
        };
        if (!std::is_sorted(rows.begin(), rows.end(), before)) std::stable_sort(rows.begin(), rows.end(), before);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            if (before(rows[i - 1], rows[i])) continue;
            const std::string of_bin = file.has_bins ? fmt::format(", bin {}", file.name_of(rows[i])) : "";
            throw UserError(
                "{}:{}:1: '{}'{} stands here again (line {} has it already; counted twice, it "
                "would look like more data than there are). {}",
                file.origin, rows[i].line, file.quantities[q], of_bin, rows[i - 1].line,
                file.has_runs ? "Remove one."
                              : "Remove one, or tell runs apart by a column 'run', bins by a "
                                "column 'bin'.");
        }
    }
}

}  // namespace

bool reports_means(std::string_view text) {
    const std::string_view header = text.substr(0, text.find('\n'));
    return header.find("estimate") == std::string_view::npos && header.find("trial") == std::string_view::npos;
}

ReportedFile parse_reported(std::string_view text, std::string_view origin, StandardErrors errors) {
    using enum ReportedColumns::Column;
    CsvReader reader(text, origin);
    const ReportedHeader header = read_reported_header(reader, origin, errors);
    const RowReader row_reader(reader, header);
    ReportedFile file;
    file.origin = origin;
    file.holds = held(header);
    file.has_errors = header[standard_error].has_value();
    file.has_n = header[n].has_value();
    file.has_cost = header[cost].has_value();
    file.has_runs = header[run].has_value();
    file.has_bins = header[bin].has_value();
    Names quantities;
    std::vector<CsvField> record;
    const std::size_t columns = static_cast<std::size_t>(
        std::count_if(header.begin(), header.end(), [](const auto& place) { return place.has_value(); }));
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    if (file.has_bins) file.names.reserve(lines);
    while (reader.next(record)) {
        if (record.size() != columns)
            reader.fail(record.front(), fmt::format("{} cells (the header has {}). Give every column a value.",
                                                    record.size(), columns));
        ReportedRow row = row_reader.read(record);
        const std::uint32_t of = quantities.index_of(row_reader.cell(record, quantity));
        if (of == file.rows.size()) file.rows.emplace_back().reserve(of == 0 && file.has_bins ? lines : 0);
        const std::string_view name = file.has_bins ? row_reader.cell(record, bin) : std::string_view("");
        // Bins follow each other, so that equal names of two quantities need not be found.
        if (file.names.empty() || file.names.back() != name) file.names.emplace_back(name);
        row.name = static_cast<std::uint32_t>(file.names.size() - 1);
        file.rows[of].push_back(row);
    }
    file.quantities = std::move(quantities.all);
    if (file.quantities.empty())
        throw UserError(
            "{}:1:1: no rows below the header (nothing would be compared). Add one for each "
            "quantity.",
            origin);
    sort_rows(file);
    return file;
}

ReportedFile load_reported(const std::filesystem::path& file, StandardErrors errors) {
    return parse_reported(read_text_file(file, FileKind::estimates), file.string(), errors);
}

double read_magnitude(const CsvReader& reader, const CsvField& field, std::string_view name,
                      std::string_view if_infinite) {
    const auto value = parse_bare_number<double>(reader.filled(field, name));
    if (!value) fail_at(reader, field, name, "not a number). Write it like 0.19982 or 2.5e-3.");
    if (!std::isfinite(*value)) fail_at(reader, field, name, fmt::format("not a finite number; {}", if_infinite));
    if (std::abs(*value) > largest_magnitude)
        fail_at(reader, field, name,
                fmt::format("beyond {:g}: its powers cannot be computed). Choose another unit.", largest_magnitude));
    return *value;
}

std::uint64_t read_index(const CsvReader& reader, const CsvField& field, std::string_view name) {
    const auto index = parse_bare_number<std::uint64_t>(reader.filled(field, name));
    if (!index)
        fail_at(reader, field, name, fmt::format("not a whole number from 0 up). Number the {}s 0, 1, 2, ...", name));
    return *index;
}

void fail_without(std::string_view wanted, std::string_view what, std::string_view origin,
                  const std::vector<std::string_view>& names, std::string_view place) {
    constexpr std::size_t most_shown = 10;
    const auto shown = std::span(names).first(std::min(names.size(), most_shown));
    throw UserError("{}: quantity = \"{}\" ({} has no such {}). {}It has: {}{}.", place, wanted, origin, what,
                    did_you_mean(wanted, names), fmt::join(shown, ", "), names.size() > most_shown ? ", ..." : "");
}

std::span<const ReportedRow> find_rows(const ReportedFile& file, std::string_view wanted, std::string_view place) {
    const auto found = std::find(file.quantities.begin(), file.quantities.end(), wanted);
    if (found != file.quantities.end()) return file.rows[static_cast<std::size_t>(found - file.quantities.begin())];
    fail_without(wanted, "quantity", file.origin, {file.quantities.begin(), file.quantities.end()}, place);
}

}  // namespace ff::studies::gates
