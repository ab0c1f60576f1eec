#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// All estimates of one quantity, in the order of their trials.
struct EstimateSeries {
    std::string quantity;
    std::vector<double> values;
    std::vector<std::size_t> lines;  ///< line in the file of each value
};

/// Estimates from any program: a CSV file with the columns trial, quantity and estimate.
struct EstimatesFile {
    std::string origin;  ///< names the file in messages
    std::vector<EstimateSeries> series;
};

/// Fewest trials of a quantity: of fewer, neither spread nor independence can be judged.
inline constexpr std::size_t fewest_estimates = 10;

/// Parses the text of a file of estimates; columns and rows may be in any order.
/// @throws UserError "origin:line:column: problem (why). Suggestion." for missing, unknown or doubled columns, missing
///         or non-numeric cells, a trial that gives a quantity twice, and too few rows
EstimatesFile parse_estimates(std::string_view text, std::string_view origin);

/// @throws IoError, UserError
EstimatesFile load_estimates_file(const std::filesystem::path& file);

/// @throws UserError at `place` where the file has no such quantity, with the nearest one
const EstimateSeries& find_series(const EstimatesFile& file, std::string_view wanted, std::string_view place);

}  // namespace ff::studies::gates
