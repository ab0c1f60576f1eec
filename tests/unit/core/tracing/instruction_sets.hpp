#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace ff::test {

/// Runs `body` once with each instruction set that the library was compiled for and this CPU has, the best first, and
/// returns what it gave; one element alone means that nothing could be compared.
template <class Body>
auto with_each_instruction_set(Body body) {
    std::vector<decltype(body())> results;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        results.push_back(body());
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return results;
}

}  // namespace ff::test
