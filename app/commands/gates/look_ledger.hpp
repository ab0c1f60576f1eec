#pragma once

#include "app/command_line/check_options.hpp"
#include "studies/verdicts/ledger.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace ff::app {

/// The look that --again requests, without its verdict. @param seed of the program's own trials
/// @throws UserError for invalid names, and for options that do not judge a commit
studies::gates::LedgerLook describe_look(const CheckCommand& command, std::uint64_t seed);

/// The file of looks.
std::filesystem::path ledger_file(const CheckCommand& command);

/// The effect of earlier looks on this one, which is recorded before it is made: a killed one counts. Nothing is
/// recorded where an earlier one failed, or judged the same data.
studies::gates::NextLook begin_look(const std::filesystem::path& file, const studies::gates::LedgerLook& look,
                                    const studies::gates::Spec& spec);

/// Records the verdict; without one, that the look was not made.
void end_look(const std::filesystem::path& file, const studies::gates::LedgerLook& look,
              std::optional<studies::gates::Verdict> verdict);

}  // namespace ff::app
