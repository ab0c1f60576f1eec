#pragma once

#include "samplers/sampler.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace ff::studies {

/// Seconds that a program may take over a set of points, where nothing else is said.
inline constexpr double usual_deadline = 60;

/// Whether a sampler is points of a program: "command:./mine --n {n} --d {d} --seed {seed}".
bool names_command(std::string_view sampler);

/// The name with a hash of those files among the words of the command that there are: a program that was changed is
/// another sampler. One that has a hash keeps it.
/// @param folder  where the program runs  @throws UserError for a command without words; IoError
std::string full_command_name(std::string_view sampler, const std::filesystem::path& folder);

/// Adds a sampler whose sets a program prints; the program runs when points are asked for. Before the first it runs
/// three times, to see that it prints the same for the same seed and something else for another.
///
/// Its words are separated by spaces, or quoted; {n}, {d}, {seed} and {trial} stand for numbers. What it prints is read
/// as a file of points is. A sampler of this name that is there already stays.
/// @param deadline  seconds for a set, above 0
/// @throws UserError for a command without words, or for other files than the hash in the name says; IoError
const samplers::CatalogueEntry& load_command(std::string_view sampler, const std::filesystem::path& folder,
                                             double deadline = usual_deadline);

}  // namespace ff::studies
