#pragma once

#include "studies/spec/spec.hpp"
#include "studies/verdicts/gate.hpp"

#include <filesystem>
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

}  // namespace ff::studies::gates
