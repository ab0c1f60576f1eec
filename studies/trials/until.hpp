#pragma once

#include "stats/two_stage.hpp"
#include "studies/store/store.hpp"
#include "studies/trials/estimates.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// Units that have to be carried out, as far as is known: all of them; in an adaptive study (StudySpec::until) the
/// pilots, and once a cell's pilot is saved, as many more as the rule asks for. Decided on the saved trials alone, so
/// the same for any number of threads and after any interruption.
std::vector<bool> needed_units(const Store& store);

/// Trials that a cell needs, as far as is known: a whole number of units.
std::uint64_t needed_trials(const Store& store, std::size_t cell);

enum class UntilFinding {
    reached,
    too_many_trials,    ///< it would take more than the study's trials
    infinite_variance,  ///< some pair has no variance: no number of trials is known to suffice
    too_few_hits,       ///< some pair has too few hits in the pilot for its spread to mean anything
    no_spread,          ///< some pair has one value in all trials of the pilot
};

/// What became of a cell of an adaptive study.
struct UntilOutcome {
    std::size_t cell = 0;
    std::uint64_t trials = 0;        ///< that were run
    std::uint64_t wanted = 0;        ///< by the rule, on the pairs that it can judge; 0 where there is none
    std::optional<double> achieved;  ///< rmse or half-width on the worst of these pairs
    std::size_t unjudged = 0;        ///< pairs that it cannot judge
    UntilFinding finding = UntilFinding::reached;
};

/// Outcomes of all sampled cells, in order; empty unless the study is adaptive and complete.
std::vector<UntilOutcome> until_outcomes(const Store& store);

/// Whether every needed unit is saved.
bool is_adaptively_complete(const Store& store);

bool all_reached(std::span<const UntilOutcome> outcomes);

}  // namespace ff::studies
