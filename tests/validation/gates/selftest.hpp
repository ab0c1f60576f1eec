#pragma once

#include "studies/verdicts/gate.hpp"
#include "tests/validation/gates/calibration.hpp"
#include "tests/validation/gates/detection.hpp"
#include "tests/validation/rates/measured_rate.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::gates {

struct SelftestOptions {
    Seed seed{1};
    std::uint64_t repetitions = 20'000;  ///< repetitions for every rate on made-up trials
    std::uint64_t seeds = 200;           ///< seeds with which every control is run
    unsigned threads = 1;
};

/// A test of the checks: what gates and intervals promise, and what they do.
struct Selftest {
    SelftestOptions options;
    Detection detection;
    Calibration calibration;
    std::vector<RateTable> estimates;  ///< skewed, correlated, heavy-tailed, repeated files
    RateTable coverage;
    double level = 0;  ///< level of the interval of one rate, such that all of them hold together with probability 0.99

    [[nodiscard]] std::vector<RateTable> tables() const;  ///< all of them, in the order of the report
    [[nodiscard]] std::size_t contradictions() const;     ///< claims that the intervals exclude
};

/// @param controls  bands file of the controls (studies/built_in/gates/controls.toml)
Selftest run_selftest(const Spec& controls, const SelftestOptions& options);

}  // namespace ff::studies::gates
