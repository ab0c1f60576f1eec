#include "studies/verdicts/check_results.hpp"

#include <algorithm>

namespace ff::studies::gates {

std::size_t CheckResults::count(Verdict verdict) const {
    return static_cast<std::size_t>(std::count_if(results.begin(), results.end(),
                                                  [&](const GateResult& result) { return result.verdict == verdict; }));
}

Verdict CheckResults::verdict() const {
    Verdict verdict = complete() ? Verdict::pass : Verdict::inconclusive;
    for (const GateResult& result : results) verdict = together(verdict, result.verdict);
    return verdict;
}

}  // namespace ff::studies::gates
