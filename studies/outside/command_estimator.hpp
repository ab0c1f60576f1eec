#pragma once

#include "core/estimators/estimator.hpp"
#include "studies/outside/program.hpp"

#include <filesystem>
#include <string_view>

namespace ff::studies {

/// Adds an estimator that is a program, "command:./mine {scene} {samples} {seed}". For every trial it receives the
/// scene as a file and prints lines from,to,estimate: a form factor for every two faces, by name. `{scene}` is OBJ
/// where all surfaces are polygons, else TOML; `{obj}`, `{toml}` and `{vs3}` have that format. Without `{samples}` it
/// has no sizes; without `{seed}` and `{trial}` one trial. An existing estimator of this name stays.
/// @throws UserError where the command does not name the scene, and as Program does; IoError
const EstimatorEntry& load_command_estimator(std::string_view name, const std::filesystem::path& folder,
                                             double deadline = usual_deadline);

}  // namespace ff::studies
