#pragma once

#include "studies/plan/plan.hpp"
#include "studies/trials/estimates.hpp"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies {

/// How trials are carried out; verdicts do not depend on it.
struct GateRunOptions {
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< give up what is in hand
};

/// Trials of the cells of a plan, kept in memory and prolonged as a gate needs them. Trial t of a cell is the same as
/// that of a study with this cell and seed.
class GateTrials {
  public:
    /// @pre the plan outlives this
    explicit GateTrials(const StudyPlan& plan);

    /// Carries out what is missing until cell c has `trials[c]` trials.
    /// @return false where it was stopped; the trials are then incomplete
    bool extend(std::span<const std::uint64_t> trials, const GateRunOptions& options);

    /// What the trials so far estimate, completed as the method says.
    [[nodiscard]] CellEstimates estimates(std::size_t cell) const;
    /// Rays and kernel values so far.
    [[nodiscard]] std::uint64_t evaluations() const;

  private:
    void keep(const UnitRecord& record, std::size_t cell);

    const StudyPlan* plan_;
    std::vector<DirectEstimates> cells_;
};

}  // namespace ff::studies
