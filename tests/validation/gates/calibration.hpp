#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

/// p-values of a gate whose effect lies exactly at the end of its band.
struct PValues {
    std::string what;
    std::size_t n = 0;
    double distance = 0;  ///< Kolmogorov-Smirnov distance from the uniform distribution
    double p = 0;         ///< p-value of that distance
};

/// The rule of gates (verdict.hpp) on trials with a known distribution: false alarms, wrong passes,
/// power.
struct Calibration {
    RateTable false_alarms;
    RateTable power;
    std::vector<PValues> p_values;
};

/// @param times  repetitions of each row
Calibration measure_calibration(const Repetitions& repetitions, std::uint64_t times);

}  // namespace ff::studies::gates
