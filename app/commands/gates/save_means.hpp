#pragma once

#include "app/command_line/check_options.hpp"

namespace ff::app {

/// Writes the contents of --estimates as a file of means for --against (--save-baseline).
/// @throws UserError, IoError
void save_means(const CheckCommand& command);

}  // namespace ff::app
