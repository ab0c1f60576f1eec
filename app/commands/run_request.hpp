#pragma once

#include "app/command_line/options.hpp"
#include "app/process/processes.hpp"
#include "studies/plan/plan.hpp"
#include "studies/plan/shard.hpp"

#include <chrono>
#include <cstdint>
#include <optional>

namespace ff::app {

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

}  // namespace ff::app
