#pragma once

#include "app/command_line/check_options.hpp"
#include "studies/verdicts/ledger.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace ff::app {

/// The look that --again asks for, but for its verdict. @param seed  of our own trials
/// @throws UserError for names that are none, and for options that judge no commit
studies::LedgerLook describe_look(const CheckCommand& command, std::uint64_t seed);

/// The file of looks.
std::filesystem::path ledger_file(const CheckCommand& command);

/// What earlier looks mean for this one, which is written down before it is made: one that is killed counts. Nothing is
/// written where an earlier one failed, or judged the same data.
studies::NextLook begin_look(const std::filesystem::path& file, const studies::LedgerLook& look,
                             const studies::GatesSpec& spec);

/// Writes the verdict; without one, that the look was not made.
void end_look(const std::filesystem::path& file, const studies::LedgerLook& look,
              std::optional<studies::Verdict> verdict);

}  // namespace ff::app
