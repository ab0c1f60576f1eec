#pragma once

#include "studies/readers/toml_reader.hpp"
#include "studies/verdicts/gate.hpp"

#include <filesystem>
#include <functional>
#include <string_view>

namespace ff::studies::gates {

/// Reads scenes, method and other keys of a gate with an experiment from its table, and rejects unknown keys.
using ReadExperiment = std::function<void(const TomlReader&, Gate&)>;

/// Parses the text of a bands file (docs/gates.md); `origin` names it in messages.
/// @param read_experiment  for gates without a quantity; null: such gates are rejected
/// @throws UserError "origin:line:column: problem (why). Suggestion."
Spec parse_bands(std::string_view text, std::string_view origin, const ReadExperiment& read_experiment);

/// @throws IoError, UserError
Spec load_bands(const std::filesystem::path& file, const ReadExperiment& read_experiment);

}  // namespace ff::studies::gates
