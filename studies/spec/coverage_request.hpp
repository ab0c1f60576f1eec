#pragma once

#include <cstdint>
#include <vector>

namespace ff::studies {

class TomlReader;

/// [coverage] of a study file: numbers of trials, each at least 3 and at most half of the study's trials.
/// @throws UserError
std::vector<std::uint64_t> read_coverage(const TomlReader& reader, std::uint64_t trials);

}  // namespace ff::studies
