#pragma once

#include "studies/gates/gate.hpp"
#include "studies/toml_reader.hpp"

namespace ff::studies {

/// The band of a gate whose other keys have been read: `band` is a width whose meaning the kind gives, or [low, high].
/// @throws UserError for a band of no width, or one that no number of trials can decide
Band read_band(const TomlReader& reader, const Gate& gate);

}  // namespace ff::studies
