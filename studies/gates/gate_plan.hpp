#pragma once

#include "studies/gates/baseline.hpp"
#include "studies/gates/gate_effects.hpp"
#include "studies/gates/gate_trials.hpp"
#include "studies/plan/plan.hpp"
#include "studies/verdicts/gate.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies {

/// What a run is for. Trials that are saved as a baseline have random numbers of their own, so that they are
/// independent of any check of the same seed.
enum class GatePurpose { check, save_baseline };

/// A gate that is ready to run, but for the number of trials.
struct GatePlan {
    std::size_t gate = 0;  ///< index into GatesSpec::gates
    GatePurpose purpose = GatePurpose::check;
    StudyPlan study;  ///< its cells
    std::vector<Effect> effects;
    std::vector<std::optional<StoredQuantity>> stored;  ///< of the baseline, for each effect
    double stored_seconds_per_trial = 0;                ///< 0 where there is no baseline
    Levels levels;
    bool deterministic = false;
    std::vector<std::uint64_t> trials;  ///< of one look, for each cell; empty until they are planned
    double wanted_trials = 0;  ///< of the cell that needs most, where that is more than max_trials allows; else 0
};

/// Trials of a pilot run; they are planned with, never judged.
inline constexpr std::uint64_t pilot_trials = 64;

/// Everything that can be wrong with a gate is found here, before any is run.
/// @param index  into spec.gates    @param baseline  null where none is given
/// @throws UserError at the gate's place
GatePlan prepare_gate(const GatesSpec& spec, std::size_t index, GatePurpose purpose, const Baseline* baseline);

/// Finds the number of trials of one look, from exact variances where they are known, otherwise from a pilot with
/// random numbers of its own.
/// @return rays and kernel values of the pilot; empty where it was stopped
/// @throws UserError where no number of trials can decide
std::optional<std::uint64_t> plan_trials(const GatesSpec& spec, GatePlan& plan, const GateRunOptions& options);

/// By the cost table: of one look, on one core.
double expected_seconds(const GatePlan& plan);

}  // namespace ff::studies
