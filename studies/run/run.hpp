#pragma once

#include "studies/plan/plan.hpp"
#include "studies/run/pace.hpp"
#include "studies/run/parallel.hpp"
#include "studies/store/store.hpp"

#include <atomic>
#include <cstdint>
#include <functional>

namespace ff::studies {

/// The progress of a run; `evaluations` are rays and kernel values.
struct RunProgress {
    std::size_t units_done = 0;
    std::size_t units = 0;
    Pace::Seconds seconds;          ///< processor time, by the plan's prices as far as measured ones correct them
    std::uint64_t evaluations = 0;  ///< evaluations in this run
    std::size_t unit = 0;           ///< the last saved unit
    double processor_seconds = 0;   ///< measured for that unit; 0 where another process ran it
    double processor_seconds_squared = 0;  ///< sum over its trials of the square of each one's
};

/// Takes a finished unit; returns false where it is no longer wanted.
using Deliver = std::function<bool(UnitRecord)>;

struct RunOptions {
    unsigned threads = 1;
    Shard shard;                                 ///< only the units of this share are carried out and counted
    Shard process;                               ///< this process's part of the missing ones
    std::function<void(const Deliver&)> others;  ///< delivers the results of other processes; called on its own thread
    const std::atomic<bool>* stop = nullptr;     ///< once true, begin no unit and return when current ones are saved
    const std::atomic<bool>* drop = nullptr;     ///< once true, units in progress are dropped: a trial can take hours
    std::function<void(const RunProgress&)> report;  ///< called on the calling thread after each saved unit
};

/// Most records waiting to be saved at a time.
constexpr std::size_t units_waiting(unsigned threads) {
    return 2 * std::size_t{threads} + 2;
}

enum class RunOutcome { complete, stopped };

/// Runs the units of the plan that the store does not hold yet and saves each in one transaction. The saved
/// observations do not depend on threads, order or interruptions. Memory is bounded: a few units wait to be saved at
/// any time, whatever the number of trials.
/// @throws what a unit or the store throws (saved units stay); UserError where the system starts too few threads
RunOutcome run_study(Store& store, const RunOptions& options);

/// Runs this process's part of the unfinished units, for another process that owns the store. `hand_over` gets each
/// record on the calling thread. @throws what a unit or `hand_over` throws
void carry_out_units(const StudyPlan& plan, const std::vector<bool>& finished, const RunOptions& options,
                     const std::function<void(const UnitRecord&)>& hand_over);

}  // namespace ff::studies
