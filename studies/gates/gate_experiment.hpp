#pragma once

#include "studies/plan/plan.hpp"
#include "studies/spec/spec.hpp"
#include "studies/trials/estimates.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// The experiment of a gate that ffstudy runs itself.
struct GateExperiment {
    std::vector<SceneSource> scenes;
    Method method;
};

/// @pre the gate does not judge estimates of another program
const GateExperiment& experiment_of(const Gate& gate);

/// Fills in a gate's experiment, and the keys that only gates with an experiment have.
/// @throws UserError for keys that are unknown or wrong
void read_experiment(const TomlReader& reader, Gate& gate);

/// The quantity that one comparison of a gate measures.
struct Effect {
    std::vector<std::size_t> cells;  ///< indices of cells of the plan: one, or the ladder of a slope
    Quantity quantity;               ///< a pair of faces or a row sum; all zeros for lost rays
    std::optional<double> truth;     ///< exact mean of `series`; empty where the scene has no exact factors
    std::optional<double> sigma;     ///< exact standard deviation of a trial, where it is known
};

/// All effects of a gate, in the order of cells, then of result tables.
/// @throws UserError at the gate's place: missing pairs, an infinite variance, or a kind that the method cannot
/// have
std::vector<Effect> effects_of(const Gate& gate, const StudyPlan& plan);

/// One value per trial: the estimate, or, for reciprocity, the difference that should be 0 on average.
std::vector<double> series(GateKind kind, const Effect& effect, const CellEstimates& estimates, const Scene& scene);

/// The labels of its row in verdicts.csv.
Comparison labelled(const Gate& gate, const Effect& effect, const StudyPlan& plan);

/// Identifies what was run, for baselines: equal texts mean equal studies, except for the code.
std::string identity(const StudyPlan& plan, std::size_t cell);

}  // namespace ff::studies::gates
