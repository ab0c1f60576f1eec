#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// The instruction sets that vectorised loops were compiled for and this processor has, by Highway's names, the best
/// first. Embree chooses its own.
std::vector<std::string> instruction_sets();

/// Restricts vectorised loops to one of them, or lifts that where the name is empty. For comparing results and times:
/// results are the same with all. Not while other threads compute.
/// @throws UserError where there is no such set, with those that there are
void use_instruction_set(std::string_view name);

}  // namespace ff
