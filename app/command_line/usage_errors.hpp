#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace ff::app {

/// What is wrong with a command line, in the form of every other message: problem (why). Suggestion.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error);

/// Rejects values that the parser accepts but nobody means: empty ones, which would silently select the default, and
/// negative counts, which would wrap around. @throws UserError
void refuse_unmeant_values(const CLI::App& app);

}  // namespace ff::app
