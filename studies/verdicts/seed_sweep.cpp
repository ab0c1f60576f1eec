#include "studies/verdicts/seed_sweep.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/binomial.hpp"

namespace ff::studies::gates {
namespace {

SweepRate rate_of(std::uint64_t count, std::uint64_t seeds, double allowed) {
    FF_EXPECT(seeds >= 1);
    SweepRate rate;
    rate.rate = static_cast<double>(count) / static_cast<double>(seeds);
    rate.interval = stats::clopper_pearson_interval({.hits = count, .trials = seeds}, 0.95);
    rate.allowed = allowed;
    rate.exceeded = rate.interval.low > allowed;
    return rate;
}

}  // namespace

void add_verdict(SeedSweep& sweep, Verdict verdict) {
    ++sweep.seeds;
    if (verdict == Verdict::fail) ++sweep.fails;
    if (verdict == Verdict::inconclusive) ++sweep.inconclusive;
}

SweepRate failure_rate(const SeedSweep& sweep, const Spec& spec) {
    return rate_of(sweep.fails, sweep.seeds, spec.alpha / static_cast<double>(spec.gates.size()));
}

SweepRate inconclusive_rate(const SeedSweep& sweep, const Spec& spec) {
    return rate_of(sweep.inconclusive, sweep.seeds, 1 - spec.power);
}

}  // namespace ff::studies::gates
