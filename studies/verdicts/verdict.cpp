#include "studies/verdicts/verdict.hpp"

namespace ff::studies {

Verdict judge(const std::optional<Measurement>& measurement, const Band& band) {
    if (!measurement) return Verdict::inconclusive;
    const Measurement& m = *measurement;
    if (m.failing.low > band.high || m.failing.high < band.low) return Verdict::fail;
    return band.holds(m.passing.low) && band.holds(m.passing.high) ? Verdict::pass : Verdict::inconclusive;
}

Verdict together(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::pass && b == Verdict::pass ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::studies
