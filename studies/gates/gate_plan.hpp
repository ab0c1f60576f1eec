#pragma once

#include "studies/gates/baseline.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/plan/plan.hpp"
#include "studies/trials/estimates.hpp"
#include "studies/verdicts/gate.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies::gates {

/// How trials are executed; verdicts do not depend on it.
struct GateRunOptions {
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< abandon work in progress
};

/// Trials of the cells of a plan, kept in memory and extended as a gate needs them. Trial t of a cell is the same as in
/// a study with this cell and seed.
class Trials {
  public:
    /// @pre the plan outlives this
    explicit Trials(const StudyPlan& plan);

    /// Runs missing trials until cell c has `trials[c]` trials.
    /// @return false where it was stopped; the trials are then incomplete
    bool extend(std::span<const std::uint64_t> trials, const GateRunOptions& options);

    /// The estimates of the trials so far, with the method's completion.
    [[nodiscard]] CellEstimates estimates(std::size_t cell) const;
    /// Rays and kernel values computed so far.
    [[nodiscard]] std::uint64_t evaluations() const;

  private:
    void keep(const UnitRecord& record, std::size_t cell);

    const StudyPlan* plan_;
    std::vector<DirectEstimates> cells_;
};

/// The purpose of a run. Trials saved as a baseline have their own random numbers, so that they are independent of any
/// check with the same seed.
enum class GatePurpose { check, save_baseline };

/// A gate that is ready to run, except for the number of trials.
struct Plan {
    std::size_t gate = 0;  ///< index into Spec::gates
    GatePurpose purpose = GatePurpose::check;
    StudyPlan study;  ///< its cells
    std::vector<Effect> effects;
    std::vector<std::optional<StoredQuantity>>
        stored;                           ///< [effect]: what the baseline has of it; empty without a baseline
    double stored_seconds_per_trial = 0;  ///< 0 where there is no baseline
    Levels levels;
    bool deterministic = false;
    std::vector<std::uint64_t> trials;  ///< trials of a look and cell; empty until planned
    double wanted_trials = 0;  ///< trials that the most demanding cell needs, if more than max_trials allows; else 0
};

/// Trials of a pilot run; they are used for planning, never judged.
inline constexpr std::uint64_t pilot_trials = 64;

/// Finds everything that can be wrong with a gate, before any is run.
/// @param index  into spec.gates    @param baseline  null where none is given
/// @throws UserError at the gate's place
Plan prepare_gate(const Spec& spec, std::size_t index, GatePurpose purpose, const Baseline* baseline);

/// Finds the number of trials of one look, from exact variances where known, otherwise from a pilot with its own random
/// numbers.
/// @return rays and kernel values of the pilot; empty where it was stopped
/// @throws UserError where no number of trials can decide
std::optional<std::uint64_t> plan_trials(const Spec& spec, Plan& plan, const GateRunOptions& options);

/// Seconds of one look on one core, by the cost table.
double expected_seconds(const Plan& plan);

}  // namespace ff::studies::gates
