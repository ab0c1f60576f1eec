#pragma once

#include "studies/spec/spec.hpp"
#include "studies/verdicts/gate.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// What a gate of our own runs.
struct GateExperiment {
    std::vector<std::string> scenes;
    Method method;
};

/// @pre the gate is not on estimates of another program
const GateExperiment& experiment_of(const Gate& gate);

/// Fills in what a gate runs, and the keys that only our own gates have.
/// @throws UserError for keys that are unknown or wrong
void read_experiment(const TomlReader& reader, Gate& gate);

}  // namespace ff::studies
