#pragma once

#include "stats/basics/moments.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/variance_interval.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// A mean square of the trials of a baseline.
struct StoredSpread : stats::MeanSquare {
    /// As it varies from trial to trial; empty in files of versions before 0.3 and for fewer than three trials.
    std::optional<stats::MeanEvidence> evidence;
};

/// The saved numbers of one quantity of one cell: enough for every comparison by a later run.
struct StoredQuantity {
    std::string cell;  ///< identifies what was run (Cell::canonical and the completion)
    Quantity quantity;
    std::uint64_t trials = 0;
    double mean = 0;
    double standard_error = 0;                      ///< standard error of the mean; 0 for a deterministic method
    gate::MeanSkewness skewness;                    ///< skewness of the mean; 0 where the file does not say
    std::optional<StoredSpread> variance;           ///< mean square about the mean; empty for a deterministic method
    std::optional<StoredSpread> mean_square_error;  ///< mean square about the exact value
};

/// The saved numbers of one gate.
struct StoredGate {
    std::string gate;
    double seconds_per_trial = 0;  ///< processor time on one core; reported, never judged
    std::vector<StoredQuantity> quantities;
};

/// A file that --save-baseline writes and --baseline reads.
struct Baseline {
    std::string origin;  ///< file name, for messages
    std::vector<StoredGate> gates;

    [[nodiscard]] const StoredGate* find(std::string_view gate) const;
};

/// The numbers to save for one quantity. @param reference exact value, where there is one
StoredQuantity store_quantity(std::string cell, Quantity quantity, std::span<const double> values,
                              std::optional<double> reference);

/// The file's text: JSON, one line per quantity; every number reads back as the same double.
std::string baseline_json(const Baseline& baseline);

/// @throws UserError with line and column where it is not such a file
Baseline parse_baseline(std::string_view text, std::string_view origin);

}  // namespace ff::studies::gates
