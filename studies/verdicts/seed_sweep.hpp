#pragma once

#include "stats/basics/interval.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies::gates {

/// Verdicts of one gate over many seeds. Each seed is an independent check: nothing is repeated until it passes.
struct SeedSweep {
    std::string gate;
    std::uint64_t seeds = 0;
    std::uint64_t fails = 0;
    std::uint64_t inconclusive = 0;
};

/// How often a gate had some outcome, and how often it may.
struct SweepRate {
    double rate = 0;
    stats::Interval interval;  ///< Clopper-Pearson, level 0.95
    double allowed = 0;
    bool exceeded = false;  ///< the interval lies above
};

void add_verdict(SeedSweep& sweep, Verdict verdict);

/// Failures against the gate's share of alpha, which is allowed where all effects lie inside their bands.
SweepRate failure_rate(const SeedSweep& sweep, const Spec& spec);

/// Undecided runs against 1 - power, which is allowed where there is no effect.
SweepRate inconclusive_rate(const SeedSweep& sweep, const Spec& spec);

}  // namespace ff::studies::gates
