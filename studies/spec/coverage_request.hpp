#pragma once

#include <cstdint>
#include <vector>

namespace ff::studies {

class TomlReader;

/// [coverage] of a study file: numbers of trials, each from 3 up, of which the study's trials make two groups at least.
/// @throws UserError
std::vector<std::uint64_t> read_coverage(const TomlReader& reader, std::uint64_t trials);

}  // namespace ff::studies
