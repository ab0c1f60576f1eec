#pragma once

#include "studies/plan.hpp"
#include "studies/records.hpp"

#include <memory>

namespace ff::studies {

/// Carries out work units of a plan. Safe to use from several threads: nothing is changed after construction.
class Worker {
  public:
    explicit Worker(const StudyPlan& plan);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// A pure function of plan and unit.
    [[nodiscard]] UnitRecord carry_out(const WorkUnit& unit) const;

  private:
    struct Tools;  // scene, tracer and points of one cell
    const StudyPlan& plan_;
    std::vector<std::unique_ptr<Tools>> tools_;
};

}  // namespace ff::studies
