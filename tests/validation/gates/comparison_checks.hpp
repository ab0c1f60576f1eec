#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// Methods compared by their RMSE, as the studies compare them: how often one of several methods of equal RMSE but
/// different laws is called better than another one, and how often one that is better is found to be.
/// @param times  repetitions of a row; each is a comparison, so that a tenth of them is run
std::vector<RateTable> measure_comparison_checks(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
