#pragma once

#include "stats/serial_correlation.hpp"
#include "studies/verdicts/estimates_file.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace ff::studies {

/// How far trials are from independent, and what follows for their mean.
struct Independence {
    std::optional<stats::Autocorrelation> correlation;  ///< where there is one
    std::string note;                                   ///< in words, where there is one
    bool enough = true;                                 ///< trials to say what a correlation costs
};

/// Refuses a series whose trials repeat; measures serial correlation in the order of trials, with a false alarm in 5 %
/// of independent series, which costs power and nothing else.
/// @throws UserError where all values are equal, where values repeat that chance does not repeat (probability below
///         1e-6), and where the series repeats itself
Independence examine_independence(const EstimateSeries& series, const std::string& origin);

/// What a gate on a file of estimates has and needs.
struct EstimatesPlan {
    std::string gate;
    GateKind kind = GateKind::bias;
    EstimateSeries series;
    std::optional<EstimateSeries> other;  ///< of the second file
    Independence independence;
    Levels levels;
    std::uint64_t needed = 0;  ///< trials with which it would pass with the power if there is no effect
};

/// @param against  a second file of trials, that distributions are compared with; null where there is none
/// @pre gate.from_estimates()
/// @throws UserError where the file has no such quantity, its trials repeat, or no number of trials can decide
EstimatesPlan plan_estimates(const GatesSpec& spec, const Gate& gate, const EstimatesFile& file,
                             const EstimatesFile* against = nullptr);

/// Judges a gate on a quantity that another program estimated, by the rules for our own. Skewness and serial
/// correlation widen the intervals of a mean. Inconclusive, with a note, where the values have a tail of infinite
/// variance or a few of them make the mean (seen from 50 values on), where they are too skewed for so few, where
/// correlated ones are worth too few independent ones, and where their spread is asked for.
/// @pre, @throws as plan_estimates
GateResult judge_estimates(const GatesSpec& spec, const Gate& gate, const EstimatesFile& file,
                           const EstimatesFile* against = nullptr);

}  // namespace ff::studies
