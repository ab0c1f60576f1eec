#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>

namespace ff::studies::gates {

/// How often each interval method contains the true value, for data that it is designed for and for others.
/// @param times  repetitions of each row; the slow ones (bootstraps) are repeated a tenth as often
RateTable measure_coverage(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
