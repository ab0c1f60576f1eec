#pragma once

#include "studies/plan/plan.hpp"

#include <cstddef>
#include <cstdint>

namespace ff::studies {

/// What the solvers may take on one system between patches, all of them together: near reflectance 1 they need
/// thousands of iterations.
inline constexpr double most_seconds_of_solvers = 10;

/// Whether solvers are run between so many patches, at a setting: where they are expected to take no longer.
bool runs_solvers(const StudyPlan& plan, double patches, std::size_t setting);

/// Bytes that systems take at their peak, beyond the program: the matrices of all trials of a cell between faces, or
/// some nine matrices between patches. 0 without [radiosity].
std::uint64_t memory_of_radiosity(const StudyPlan& plan);

/// Seconds that they take on one core, by their floating-point operations. Some factor of two: how many iterations a
/// solver takes is known for exact factors only.
double seconds_of_radiosity(const StudyPlan& plan);

}  // namespace ff::studies
