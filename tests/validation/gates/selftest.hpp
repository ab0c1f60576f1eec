#pragma once

#include "studies/explain/descriptions.hpp"
#include "studies/selftest/calibration.hpp"
#include "studies/selftest/detection.hpp"
#include "studies/selftest/measured_rate.hpp"
#include "studies/verdicts/gate.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies {

/// Listed and explained along with the studies that are files.
inline constexpr Description selftest_description{
    "gates_selftest", "Check the gates and intervals themselves: what is broken is caught, what is sound is not",
    "Runs every control ('ffstudy list controls') through its gate with many seeds, and its sound counterpart beside "
    "it;\nmeasures false alarms at the ends of the band and at a point null, p-values, power, the coverage of every "
    "interval\nmethod, and what becomes of estimates that are skewed, correlated, repeated or of infinite variance. "
    "Claims are tested "
    "together, at 1 %;\nexit code 1 where one does not hold. A command of its own: ffstudy gates_selftest --help.",
    ""};

struct SelftestOptions {
    Seed seed{1};
    std::uint64_t repetitions = 20'000;  ///< of every rate on made-up trials
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
    double level = 0;  ///< of the interval of one rate, such that all of them hold together with probability 0.99

    [[nodiscard]] std::vector<RateTable> tables() const;  ///< all of them, in the order of the report
    [[nodiscard]] std::size_t contradictions() const;     ///< claims that the intervals exclude
};

/// @param controls  bands file of the controls (studies/built_in/gates/controls.toml)
Selftest run_selftest(const GatesSpec& controls, const SelftestOptions& options);

}  // namespace ff::studies
