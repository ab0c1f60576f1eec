#include "studies/verdicts/verdict.hpp"

namespace ff::studies::gates {

Verdict judge(const std::optional<Measurement>& measurement, const Band& band) {
    return measurement ? gate::judge(measurement->passing, measurement->failing, band) : Verdict::inconclusive;
}

Verdict together(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::pass && b == Verdict::pass ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::studies::gates
