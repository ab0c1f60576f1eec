#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/commands/gates/check_estimates.hpp"
#include "app/folders/output_folder.hpp"
#include "app/process/exit_code.hpp"

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/ledger.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ff::app {

inline constexpr const char* check_summary = "Check the gates of a bands file: pass, fail or inconclusive";

/// Options of `ffstudy check` for gates on what other programs report.
void add_options_of_files(CommandDefinition& sub, CheckCommand& command);

/// `ffstudy check` of the smaller program, which has these gates only.
void add_check_of_files(ProgramDefinition& program);

/// Writes the contents of --estimates as a file of means for --against (--save-baseline).
/// @throws UserError, IoError
void save_means(const CheckCommand& command);

/// Shows the verdict of a finished gate, and writes those of all finished ones.
/// @param note  shown beside the verdict, not judged; may be empty
using Tell = std::function<void(studies::gates::GateResult result, double seconds, const std::string& note)>;

/// Runs gates, one after the other.
using RunGates = std::function<void(const Tell&)>;

/// Validates the gates that have to be run, before any of them is run.
using PrepareGates = std::function<RunGates(const studies::gates::Spec&)>;

/// One `ffstudy check`: gates on files are judged, others are run.
struct CheckSession {
    const CheckCommand& command;
    studies::gates::Spec spec;
    std::map<std::string, std::string> context;  ///< content of context.json
    PrepareGates prepare;                        ///< null where no gate has to be run

    [[nodiscard]] std::filesystem::path out() const;
    void print(const std::string& text) const;
};

/// Judges all gates, or looks at a commit again (--again), writes and prints the verdicts.
/// @throws UserError, IoError
ExitCode judge(CheckSession session);

/// The folder for these files, after checking that they may be written.
OutputFolder open_folder(const std::filesystem::path& out, const std::vector<std::string>& files);

/// The look that --again requests at these gates, without its verdict.
/// @throws UserError for invalid names, and for options that do not judge a commit
studies::gates::LedgerLook describe_look(const CheckCommand& command, const studies::gates::Spec& spec);

}  // namespace ff::app
