#include "studies/resources.hpp"

#include "studies/records.hpp"
#include "studies/run.hpp"
#include "studies/store.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

constexpr std::uint64_t program = 30ULL << 20;  // code, libraries, the scene, the reports as they are written
constexpr std::uint64_t bytes_of_a_row = 30;    // of an observation in the store, keys and page overhead included
constexpr double seconds_of_a_row = 3e-6;       // two thirds to save it, one to read and evaluate it
constexpr std::uint64_t bytes_of_a_line = 100;  // of trials.csv, while it is made

std::uint64_t observations_per_trial(const StudyPlan& plan, const Cell& cell) {
    const std::uint64_t faces = plan.scenes[cell.scene].faces.size();
    return faces * faces;
}

/// Sums and sums of squares of the hits, or factors, of each patch on each face.
std::uint64_t patch_sums(const StudyPlan& plan, const Cell& cell) {
    const Estimator estimator = plan.spec.methods[cell.method].estimator;
    if (estimator != Estimator::ray_shooting && estimator != Estimator::area_kernel) return 0;
    const std::uint64_t patches = cell.subdivision.patches(plan.scenes[cell.scene]);
    return 2 * sizeof(std::uint64_t) * patches * plan.scenes[cell.scene].faces.size();
}

std::uint64_t largest_record(const StudyPlan& plan) {
    std::uint64_t largest = 0;
    for (const WorkUnit& unit : plan.units) {
        const Cell& cell = plan.cells[unit.cell];
        // Lists grow by doubling: half of the room is used on average.
        const std::uint64_t observations = 2 * unit.trials * observations_per_trial(plan, cell) * sizeof(Observation);
        largest = std::max(largest, observations + patch_sums(plan, cell));
    }
    return largest;
}

std::uint64_t memory_of_analysis(const StudyPlan& plan) {
    std::uint64_t largest = 0;
    std::uint64_t all = 0;
    for (const Cell& cell : plan.cells) {
        const std::uint64_t faces = plan.scenes[cell.scene].faces.size();
        const std::uint64_t estimates = cell.trials * sizeof(double) * (faces * faces + 2 * faces + 8);
        largest = std::max(largest, estimates + cell.trials * bytes_of_a_line);
        all += estimates;
    }
    return plan.spec.published ? largest + all : largest;
}

}  // namespace

std::uint64_t expected_store_size(const StudyPlan& plan) {
    std::uint64_t bytes = 0;
    for (const Cell& cell : plan.cells) bytes += cell.trials * observations_per_trial(plan, cell) * bytes_of_a_row;
    for (const WorkUnit& unit : plan.units) bytes += patch_sums(plan, plan.cells[unit.cell]);
    return bytes;
}

double expected_seconds_of_results(const StudyPlan& plan) {
    double observations = 0;
    for (const Cell& cell : plan.cells)
        observations += static_cast<double>(cell.trials * observations_per_trial(plan, cell));
    return observations * seconds_of_a_row;
}

std::uint64_t expected_memory(const StudyPlan& plan, unsigned threads) {
    const std::uint64_t units =
        std::min<std::uint64_t>(plan.units.size(), threads + units_waiting(threads) + std::uint64_t{1});
    const std::uint64_t running =
        units * largest_record(plan) + std::min(Store::page_cache_bytes, expected_store_size(plan));
    return program + std::max(running, memory_of_analysis(plan)) + plan.units.size() * sizeof(WorkUnit);
}

}  // namespace ff::studies
