#pragma once

#include "stats/means/mean_interval.hpp"
#include "studies/store/store.hpp"
#include "studies/trials/estimates.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// Units that have to be run, as far as known: all of them; in an adaptive study (StudySpec::until) the pilots, and
/// once a cell's pilot is saved, as many more as the rule requires. Decided on saved trials alone, hence the same for
/// any number of threads and after any interruption.
std::vector<bool> needed_units(const Store& store);

/// Trials that a cell needs, as far as known: a whole number of units.
std::uint64_t needed_trials(const Store& store, std::size_t cell);

enum class UntilFinding {
    reached,
    too_many_trials,    ///< more than the study's trials would be needed
    infinite_variance,  ///< some pair has no variance: no number of trials is known to suffice
    too_few_hits,       ///< some pair has too few hits in the pilot for a meaningful spread
    no_spread,          ///< some pair has one value in all trials of the pilot
};

/// The outcome for a cell of an adaptive study.
struct UntilOutcome {
    std::size_t cell = 0;
    std::uint64_t trials = 0;  ///< number of trials that were run
    std::uint64_t wanted = 0;  ///< trials required by the rule, on the pairs that it can judge; 0 where there are none
    std::optional<double> achieved = {};  ///< rmse or half-width on the worst of these pairs
    std::size_t unjudged = 0;             ///< pairs that the rule cannot judge
    UntilFinding finding = UntilFinding::reached;
};

/// Outcomes of all sampled cells, in order; empty unless the study is adaptive and complete.
std::vector<UntilOutcome> until_outcomes(const Store& store);

/// Whether every needed unit is saved.
bool is_adaptively_complete(const Store& store);

bool all_reached(std::span<const UntilOutcome> outcomes);

}  // namespace ff::studies
