#pragma once

#include "samplers/sampler.hpp"
#include "studies/outside/program.hpp"

#include <filesystem>
#include <string_view>

namespace ff::studies {

/// Adds a sampler whose sets a program prints, "command:./mine --n {n} --d {d} --seed {seed}"; it runs when points are
/// requested. Its output is read like a file of points. An existing sampler of this name stays.
/// @throws UserError, IoError as Program does
const samplers::CatalogueEntry& load_command_sampler(std::string_view name, const std::filesystem::path& folder,
                                                     double deadline = usual_deadline);

}  // namespace ff::studies
