#include "studies/verdicts/gate_result.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/binomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ff::studies::gates {
namespace {

int severity(Verdict verdict) {
    return verdict == Verdict::fail ? 2 : verdict == Verdict::inconclusive ? 1 : 0;
}

/// How far the middle of the interval lies from the middle of the band, in half widths of the band; of one end where
/// the other is infinite.
double strain(const Comparison& comparison) {
    if (!comparison.measurement) return std::numeric_limits<double>::infinity();
    const Band& band = comparison.band;
    const auto& interval = comparison.measurement->passing;
    const double above = interval.high - band.high;
    const double below = band.low - interval.low;
    const double width = std::isfinite(band.high - band.low) ? band.high - band.low : 1.0;
    return std::max(above, below) / std::max(width, std::numeric_limits<double>::min());
}

SweepRate rate_of(const stats::Proportion& outcomes, double allowed) {
    const auto interval = stats::clopper_pearson_interval(outcomes, 0.95);
    return {.rate = outcomes.share(), .interval = interval, .allowed = allowed, .exceeded = interval.low > allowed};
}

}  // namespace

GateResult result_of(const Gate& gate, const Comparison& comparison) {
    return {.gate = gate.name,
            .kind = gate.kind,
            .verdict = comparison.verdict,
            .comparisons = {comparison},
            .note = comparison.note};
}

Verdict verdict_of(const std::vector<Comparison>& comparisons) {
    if (comparisons.empty()) return Verdict::inconclusive;
    Verdict verdict = Verdict::pass;
    for (const Comparison& comparison : comparisons) verdict = together(verdict, comparison.verdict);
    return verdict;
}

const Comparison& decisive(const std::vector<Comparison>& comparisons) {
    FF_EXPECT(!comparisons.empty());
    return *std::max_element(comparisons.begin(), comparisons.end(), [](const Comparison& a, const Comparison& b) {
        return std::tuple(severity(a.verdict), strain(a)) < std::tuple(severity(b.verdict), strain(b));
    });
}

std::size_t CheckResults::count(Verdict verdict) const {
    return static_cast<std::size_t>(std::count_if(results.begin(), results.end(),
                                                  [&](const GateResult& result) { return result.verdict == verdict; }));
}

Verdict CheckResults::verdict() const {
    Verdict verdict = complete() ? Verdict::pass : Verdict::inconclusive;
    for (const GateResult& result : results) verdict = together(verdict, result.verdict);
    return verdict;
}

void add_verdict(SeedSweep& sweep, Verdict verdict) {
    ++sweep.seeds;
    if (verdict == Verdict::fail) ++sweep.fails;
    if (verdict == Verdict::inconclusive) ++sweep.inconclusive;
}

SweepRate failure_rate(const SeedSweep& sweep, const Spec& spec) {
    return rate_of({sweep.fails, sweep.seeds}, spec.alpha / static_cast<double>(spec.gates.size()));
}

SweepRate inconclusive_rate(const SeedSweep& sweep, const Spec& spec) {
    return rate_of({sweep.inconclusive, sweep.seeds}, 1 - spec.power);
}

}  // namespace ff::studies::gates
