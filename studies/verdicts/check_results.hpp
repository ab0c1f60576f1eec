#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies::gates {

/// The finished gates of a file; every report is made from it.
struct CheckResults {
    Spec spec;
    std::vector<GateResult> results;  ///< in the order of completion; found by name

    [[nodiscard]] bool complete() const { return results.size() == spec.gates.size(); }
    [[nodiscard]] std::size_t count(Verdict verdict) const;
    /// The verdict of all gates together; those that have not run are inconclusive.
    [[nodiscard]] Verdict verdict() const;
};

}  // namespace ff::studies::gates
