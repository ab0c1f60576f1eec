#pragma once

#include "studies/gates/gate.hpp"
#include "studies/selftest/calibration.hpp"
#include "studies/selftest/detection.hpp"
#include "studies/selftest/measured_rate.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies {

struct SelftestOptions {
    Seed seed{1};
    std::uint64_t repetitions = 20'000;  ///< of every rate on made-up trials
    std::uint64_t seeds = 200;           ///< with which every control is run
    unsigned threads = 1;
};

/// The checks checked: what gates and intervals promise, beside what they do.
struct Selftest {
    SelftestOptions options;
    Detection detection;
    Calibration calibration;
    RateTable coverage;
    double level = 0;  ///< of the interval of one rate, such that all of them hold together with probability 0.99

    [[nodiscard]] std::vector<RateTable> tables() const;  ///< all of them, in the order of the report
    [[nodiscard]] std::size_t contradictions() const;     ///< claims that the intervals exclude
};

/// @param controls  bands file of the controls (studies/gates/controls.toml)
Selftest run_selftest(const GatesSpec& controls, const SelftestOptions& options);

}  // namespace ff::studies
