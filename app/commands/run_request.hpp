#pragma once

#include "app/command_line/common_options.hpp"
#include "app/process/exit_code.hpp"
#include "app/process/processes.hpp"

#include "studies/plan/plan.hpp"
#include "studies/run/parallel.hpp"
#include "studies/spec/convergence_study.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace ff::app {

/// Settings of `ffstudy radiosity` that override those of the study file; empty texts override nothing.
struct RadiosityOptions {
    std::string reflectance;  ///< "0.5,0.9"
    std::string emission;     ///< "0,0,0,0,0,1"
    std::optional<std::uint64_t> patch_trials;
};

/// Options of commands that run a study.
struct RunCommand {
    std::string study;  ///< built-in name, or a file
    std::optional<std::uint64_t> trials;
    std::optional<std::uint64_t> seed;
    std::optional<unsigned> threads;
    std::optional<std::string> shard;       ///< "i/n"
    std::optional<std::string> max_time;    ///< "90", "15m"
    std::optional<std::string> max_memory;  ///< "500M"
    std::filesystem::path out;              ///< empty: results/<study>
    std::filesystem::path templates;        ///< folder of custom templates; empty: none
    bool quiet = false;
    bool replace = false;  ///< replace another study in the folder
    bool dry_run = false;
    std::optional<studies::ConvergenceRequest> convergence;  ///< instead of `study`
    std::optional<RadiosityOptions> radiosity;
    std::optional<std::string> until;  ///< "rmse=1e-5" or "ci=1e-5"
    std::optional<double> level;
    OutsideOptions outside;
    std::filesystem::path study_file;  ///< file that the study is written to; empty: none
};

/// The validated request of a run command; nothing has been written yet.
struct RunRequest {
    studies::StudyPlan plan;
    unsigned threads = 1;
    studies::Shard shard;
    std::optional<std::chrono::duration<double>> max_time;
    std::optional<std::uint64_t> max_memory;  ///< bytes; threads are few enough to keep within it, by the plan
};

/// Radiosity settings of the command line. @throws UserError
void set_light(studies::RadiosityRequest& light, const RadiosityOptions& options);

/// @throws UserError, IoError
RunRequest check(const RunCommand& command, const Processes& processes);

/// Runs or resumes a study, writes its reports, prints a short result.
ExitCode run(const RunCommand& command);

}  // namespace ff::app
