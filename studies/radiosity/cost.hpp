#pragma once

#include "studies/plan/plan.hpp"

#include <cstddef>
#include <cstdint>

namespace ff::studies::radiosity {

/// Whether solvers are run between this many patches at a setting: where their expected cost is within the limit.
bool runs_solvers(const StudyPlan& plan, double patches, std::size_t setting);

/// Peak bytes of systems, beyond the program: the matrices of all trials of a cell between faces, or about nine
/// matrices between patches. 0 without [radiosity].
std::uint64_t memory_needed(const StudyPlan& plan);

/// Their seconds on one core, by floating-point operations. Right within about a factor of two: the number of
/// iterations is known for exact factors only.
double seconds_needed(const StudyPlan& plan);

}  // namespace ff::studies::radiosity
