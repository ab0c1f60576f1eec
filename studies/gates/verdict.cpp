#include "studies/gates/verdict.hpp"

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

Verdict judge(const std::optional<Evidence>& evidence, const Band& band) {
    if (!evidence) return Verdict::inconclusive;
    if (evidence->failing.low > band.high || evidence->failing.high < band.low) return Verdict::fail;
    return band.holds(evidence->passing.low) && band.holds(evidence->passing.high) ? Verdict::pass
                                                                                   : Verdict::inconclusive;
}

Verdict together(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::pass && b == Verdict::pass ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::studies
