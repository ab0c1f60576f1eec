#pragma once

#include "studies/plan/plan.hpp"
#include "studies/trials/estimates.hpp"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies::gates {

/// How trials are executed; verdicts do not depend on it.
struct GateRunOptions {
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< abandon work in progress
};

/// Trials of the cells of a plan, kept in memory and extended as a gate needs them. Trial t of a cell is the same as in
/// a study with this cell and seed.
class Trials {
  public:
    /// @pre the plan outlives this
    explicit Trials(const StudyPlan& plan);

    /// Runs missing trials until cell c has `trials[c]` trials.
    /// @return false where it was stopped; the trials are then incomplete
    bool extend(std::span<const std::uint64_t> trials, const GateRunOptions& options);

    /// The estimates of the trials so far, with the method's completion.
    [[nodiscard]] CellEstimates estimates(std::size_t cell) const;
    /// Rays and kernel values computed so far.
    [[nodiscard]] std::uint64_t evaluations() const;

  private:
    void keep(const UnitRecord& record, std::size_t cell);

    const StudyPlan* plan_;
    std::vector<DirectEstimates> cells_;
};

}  // namespace ff::studies::gates
