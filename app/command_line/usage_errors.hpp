#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace ff::app {

/// What is wrong with a command line, in the form of every other message: problem (why). Suggestion.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error);

/// Values that the parser takes and that are not meant: empty ones, which would silently mean the default, and negative
/// ones of options that count, which would wrap around. @throws UserError
void refuse_unmeant_values(const CLI::App& app);

}  // namespace ff::app
