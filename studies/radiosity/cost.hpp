#pragma once

#include "studies/plan.hpp"

#include <cstdint>

namespace ff::studies {

/// Bytes that systems take at their peak, beyond the program: the matrices of all trials of a cell between faces, or
/// some nine matrices between patches. 0 without [radiosity].
std::uint64_t memory_of_radiosity(const StudyPlan& plan);

/// Seconds that they take on one core, by their floating-point operations. Some factor of two: how many iterations a
/// solver takes is known for exact factors only.
double seconds_of_radiosity(const StudyPlan& plan);

}  // namespace ff::studies
