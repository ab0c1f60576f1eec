#pragma once

#include "app/command_line/check_options.hpp"
#include "app/folders/output_folder.hpp"
#include "app/process/exit_code.hpp"

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ff::app {

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

}  // namespace ff::app
