#pragma once

#include "studies/plan/plan.hpp"

#include <cstdint>

namespace ff::studies {

/// Peak bytes for running a plan and evaluating its results, by the sizes of what is held at a time: a few units per
/// thread, pages of the store, the trials of one cell (of all cells where tables are compared). Within a factor of two
/// of measurements on the built-in studies; docs/reliability.md has the figures.
std::uint64_t expected_memory(const StudyPlan& plan, unsigned threads);

/// Size of the finished store in bytes.
std::uint64_t expected_store_size(const StudyPlan& plan);

/// Seconds for saving and evaluating all observations; it runs on one core whatever the number of threads.
double expected_seconds_of_results(const StudyPlan& plan);

}  // namespace ff::studies
