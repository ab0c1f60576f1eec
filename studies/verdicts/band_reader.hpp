#pragma once

#include "studies/readers/toml_reader.hpp"
#include "studies/verdicts/gate.hpp"

#include <string_view>

namespace ff::studies::gates {

/// @throws UserError for a number whose powers leave the range of doubles: beyond 1e75, or nearer to 0 than 1e-75
void expect_magnitude(const TomlReader& reader, std::string_view key, double number);

/// The band of a gate whose other keys have been read: `band` is a width, interpreted by the kind, or [low, high].
/// @throws UserError for a band of no width, or one that no number of trials can decide
Band read_band(const TomlReader& reader, const Gate& gate);

}  // namespace ff::studies::gates
