#pragma once

#include "studies/verdicts/estimates_file.hpp"
#include "studies/verdicts/reported_file.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// One quantity of one run: a line of a history.
struct HistoryRow {
    std::string commit;
    std::string quantity;
    double mean = 0;
    double standard_error = 0;
    double n = 0;                ///< samples behind the error; 0 where not stated
    std::optional<double> cost;  ///< in any unit

    /// Standard deviation of a single trial; empty where n is not stated.
    [[nodiscard]] std::optional<double> spread() const;
};

/// All runs, the oldest first: a CSV file with the columns commit, quantity, mean, standard_error, n, cost.
using History = std::vector<HistoryRow>;

/// @throws UserError "origin:line:column: ..."
History parse_history(std::string_view text, std::string_view origin);
std::string history_csv(const History& history);

/// The entries to keep from a file of trials.
History summarise(const EstimatesFile& file, const std::string& commit);

/// The entries to keep from a file of means: quantities with one bin and one run. The others are named in `left_out`.
History summarise(const ReportedFile& file, const std::string& commit, std::vector<std::string>& left_out);

/// Whether the history has this commit already.
bool has_commit(const History& history, std::string_view commit);

}  // namespace ff::studies
