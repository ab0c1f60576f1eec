#pragma once

// Shared by stats/gates/gate.hpp and by studies/verdicts/: C++17, the standard library alone.

#include <string_view>

namespace ff::gate {

/// The verdict of a gate. Inconclusive is not a pass: the trials were too few to tell.
enum class Verdict { pass, fail, inconclusive };

/// "pass", "fail" or "inconclusive".
constexpr std::string_view name(Verdict verdict) {
    return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "inconclusive";
}

/// The rule of every gate, whose null hypothesis is composite ("inside the band"). Fail: the failing interval, of level
/// 1 - alpha, lies wholly outside. Pass: the passing one, of level 1 - 2 pass_alpha, lies inside. Otherwise
/// inconclusive.
template <class Interval, class Band>
constexpr Verdict judge(const Interval& passing, const Interval& failing, const Band& band) {
    if (failing.low > band.high || failing.high < band.low) return Verdict::fail;
    return passing.low >= band.low && passing.high <= band.high ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::gate
