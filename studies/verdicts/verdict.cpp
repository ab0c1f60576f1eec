#include "studies/verdicts/verdict.hpp"

namespace ff::studies {

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "fail";
        case Verdict::inconclusive:
            break;
    }
    return "inconclusive";
}

Verdict judge(const std::optional<Measurement>& measurement, const Band& band) {
    if (!measurement) return Verdict::inconclusive;
    const Measurement& m = *measurement;
    if (m.failing.low > band.high && !m.below_is_open) return Verdict::fail;
    if (m.failing.high < band.low && !m.above_is_open) return Verdict::fail;
    const bool inside = band.holds(m.passing.low) && band.holds(m.passing.high);
    return inside && !m.passing_is_open ? Verdict::pass : Verdict::inconclusive;
}

Verdict together(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::pass && b == Verdict::pass ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::studies
