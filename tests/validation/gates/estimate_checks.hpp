#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Verdicts on files of estimates that are not normal and independent, and on trials that all give one value.
/// @param times  repetitions of a row; slow ones are repeated less often
std::vector<RateTable> measure_estimate_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
