#pragma once

#include "studies/readers/csv_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// The meaning of the column of values.
enum class Holds {
    means,
    counts,  ///< events in a bin of a histogram
    shares,  ///< known probabilities of bins
    hits,    ///< successes in n independent trials
};

/// A code's report of one bin in one run. A million of them are common, hence the narrow members.
struct ReportedRow {
    double mean = 0;            ///< or the count, the share, or the hits
    double standard_error = 0;  ///< standard error of the mean; 0 where the file has none
    double n = 0;               ///< samples or batches behind it, or trials behind hits; 0 where not stated
    double cost = 0;            ///< seconds, or whatever the code counts; 0 where not stated
    std::uint64_t run = 0;
    std::uint32_t name = 0;  ///< index into ReportedFile::names: the bin, or the quantity where it has no bins
    std::uint32_t line = 0;

    /// Whether a bin of means has no sample, hence neither mean nor spread.
    [[nodiscard]] bool is_empty() const { return mean == 0 && standard_error == 0; }
};

/// Means with standard errors as another program reports them: a CSV file with the columns quantity, mean and
/// standard_error, and optionally n, cost, bin and run. Or a histogram: quantity, bin and count, or share. Or hits of n
/// trials: quantity, hits and n, and optionally bin and run.
struct ReportedFile {
    std::string origin;  ///< names the file in messages
    Holds holds = Holds::means;
    std::vector<std::string> quantities;         ///< in the order of their first rows
    std::vector<std::string> names;              ///< names of the bins
    std::vector<std::vector<ReportedRow>> rows;  ///< rows of each quantity, in the order of bins and runs
    bool has_errors = false;                     ///< whether the file has the column standard_error
    bool has_n = false;
    bool has_cost = false;
    bool has_runs = false;
    bool has_bins = false;

    [[nodiscard]] std::string_view name_of(const ReportedRow& row) const { return names[row.name]; }
};

/// Whether standard errors are required. Exact values have none.
enum class StandardErrors { required, optional };

/// Whether the text begins with the header of such a file rather than with that of a file of trials.
bool reports_means(std::string_view text);

/// @throws UserError "origin:line:column: problem (why). Suggestion." for wrong columns and cells, standard errors that
///   are negative, or 0 beside a nonzero mean, duplicate rows, and a file without rows
ReportedFile parse_reported(std::string_view text, std::string_view origin, StandardErrors errors);

/// @throws IoError, UserError
ReportedFile load_reported(const std::filesystem::path& file, StandardErrors errors);

/// A finite number whose powers can be computed. @param name  of its column @param if_infinite  the problem of one that
/// is not finite, and a suggestion
double read_magnitude(const CsvReader& reader, const CsvField& field, std::string_view name,
                      std::string_view if_infinite);

/// A number of a trial or a run. @param name  of its column
std::uint64_t read_index(const CsvReader& reader, const CsvField& field, std::string_view name);

/// @throws UserError at `place`: a file has data on other quantities only @param what  the kind of data that is missing
[[noreturn]] void fail_without(std::string_view wanted, std::string_view what, std::string_view origin,
                               const std::vector<std::string_view>& names, std::string_view place);

/// The rows of a quantity. @throws UserError at `place` where the file has no such quantity, with the nearest
/// one
std::span<const ReportedRow> find_rows(const ReportedFile& file, std::string_view wanted, std::string_view place);

}  // namespace ff::studies::gates
