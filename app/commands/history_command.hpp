#pragma once

#include "app/command_line/check_options.hpp"
#include "app/process/exit_code.hpp"

namespace ff::app {

/// Checks --history and --commit before anything is judged. @throws UserError
void expect_history(const CheckCommand& command);

/// Adds a line for each quantity of --estimates to the file of --history.
/// @throws UserError where the commit is already there, or there is nothing to keep
void add_to_history(const CheckCommand& command);

/// Writes the contents of --estimates as a file of means for --against (--save-baseline).
void save_means(const CheckCommand& command);

/// Looks for changes over the commits of a history: failed where one is found, inconclusive where nothing could be
/// tested.
ExitCode trend(const TrendCommand& command);

}  // namespace ff::app
