#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// The gates of a file as far as they are done; every report is made from it.
struct CheckResults {
    GatesSpec spec;
    std::vector<GateResult> results;  ///< in the order in which they were done; found by their name

    [[nodiscard]] bool complete() const { return results.size() == spec.gates.size(); }
    [[nodiscard]] std::size_t count(Verdict verdict) const;
    /// Of all gates together; those that have not run are inconclusive.
    [[nodiscard]] Verdict verdict() const;
};

}  // namespace ff::studies
