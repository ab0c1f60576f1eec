#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Verdicts on means with standard errors: arrays of bins under each combination, right and wrong stated errors, and,
/// beside our rule, rules that other projects report using.
/// @param times  repetitions of a row; those on many bins are repeated less often
std::vector<RateTable> measure_reported_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
