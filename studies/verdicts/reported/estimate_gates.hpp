#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/estimates_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace ff::studies::gates {

/// The trials that a gate on a file would need.
struct EstimatesPlan {
    std::string gate;
    GateKind kind = GateKind::bias;
    std::size_t comparisons = 1;  ///< bins
    std::uint64_t needed = 0;     ///< trials with which it would pass with the power if there is no effect
    std::uint64_t at_hand = 0;
    bool in_runs = false;  ///< `needed` and `at_hand` are runs of means or shares, not trials
};

/// @param against  a second file of trials to compare distributions with; null: none
/// @pre gate.from_estimates()
/// @throws UserError where the file has no such quantity, its trials repeat, or no number of trials can decide
EstimatesPlan plan_estimates(const Spec& spec, const Gate& gate, const EstimatesFile& file,
                             const EstimatesFile* against = nullptr);

/// Judges a gate on a quantity that another program estimated, by the rules for our own. Skewness and serial
/// correlation widen the intervals of a mean. Inconclusive, with a note, where the values have a tail of infinite
/// variance or a few of them dominate the mean (detectable from 50 values on), where they are too skewed for their
/// number, and, if they are correlated, where they are worth too few independent ones or their spread is to be judged.
/// @pre, @throws as plan_estimates
GateResult judge_estimates(const Spec& spec, const Gate& gate, const EstimatesFile& file,
                           const EstimatesFile* against = nullptr);

}  // namespace ff::studies::gates
