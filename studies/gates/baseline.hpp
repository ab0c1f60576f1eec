#pragma once

#include "stats/moments.hpp"
#include "stats/spread.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// What is kept of one quantity of one cell: enough for every comparison that a later run makes with it.
struct StoredQuantity {
    std::string cell;  ///< what was run (Cell::canonical and the completion)
    Quantity quantity;
    std::uint64_t trials = 0;
    double mean = 0;
    double standard_error = 0;                       ///< of the mean; 0 for a deterministic method
    std::optional<stats::Spread> variance;           ///< about the mean; empty for a deterministic method
    std::optional<stats::Spread> mean_square_error;  ///< about the exact value
};

/// What is kept of one gate.
struct StoredGate {
    std::string gate;
    double seconds_per_trial = 0;  ///< of one core; told, never judged
    std::vector<StoredQuantity> quantities;
};

/// A file that --save-baseline writes and --baseline reads.
struct Baseline {
    std::string origin;  ///< file name, for messages
    std::vector<StoredGate> gates;

    [[nodiscard]] const StoredGate* find(std::string_view gate) const;
};

/// Numbers of one quantity. @param reference  exact value, where there is one
StoredQuantity store_quantity(std::string cell, Quantity quantity, std::span<const double> values,
                              std::optional<double> reference);

/// The file's text: JSON, one line a quantity; every number reads back as the same double.
std::string baseline_json(const Baseline& baseline);

/// @throws UserError with line and column where it is no such file
Baseline parse_baseline(std::string_view text, std::string_view origin);

}  // namespace ff::studies
