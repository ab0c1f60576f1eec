#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Whole families of means under the rule for means (stats/means/mean_test.hpp): how many find a bias where there is
/// none, in trials of many laws, and how many find one of a known size.
/// @param times  repetitions of a row; each is a family of 30 means, so that a twentieth of them is run
std::vector<RateTable> measure_study_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
