#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Gates of kind `distribution` on counts and on values: false alarms without a difference and at the end of the band,
/// power, wrong passes, and how often intervals contain the distance.
std::vector<RateTable> measure_distribution_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
