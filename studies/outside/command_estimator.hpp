#pragma once

#include "core/estimators/estimator.hpp"
#include "studies/outside/program.hpp"

#include <filesystem>
#include <string_view>

namespace ff::studies {

/// Adds an estimator that is a program, "command:./mine {scene} {samples} {seed}". For every trial it gets the scene as
/// a file and prints the lines from,to,estimate: a form factor for each two faces, by their names. A `{scene}` is OBJ
/// where all surfaces are polygons and TOML elsewhere; `{obj}`, `{toml}` and `{vs3}` are of that format. Without
/// `{samples}` it has no sizes; without `{seed}` and `{trial}` one trial. An estimator of this name stays.
/// @throws UserError where it does not name the scene, and as Program does; IoError
const EstimatorEntry& load_command_estimator(std::string_view name, const std::filesystem::path& folder,
                                             double deadline = usual_deadline);

}  // namespace ff::studies
