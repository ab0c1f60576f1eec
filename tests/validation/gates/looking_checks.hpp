#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Verdicts on gates that are looked at until decided: with all of alpha each time, with the shares of a ledger, and
/// with confidence sequences.
std::vector<RateTable> measure_looking_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
