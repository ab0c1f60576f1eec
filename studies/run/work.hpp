#pragma once

#include "core/points/points.hpp"
#include "studies/plan/plan.hpp"
#include "studies/store/records.hpp"

#include <atomic>
#include <cstdint>
#include <memory>

namespace ff::studies {

/// Thrown out of a trial that is no longer wanted; its counts are lost.
struct Interrupted {};

/// The points of a cell. Null where its method takes none.
/// @param stop  once true, every further request throws `Interrupted`; outlives the result; null: never
std::unique_ptr<PointSource> make_points(const Method& method, const Cell& cell, const std::atomic<bool>* stop);

/// The first trials of a unit, from an earlier study.
struct BegunUnit {
    std::uint64_t trials = 0;
    UnitRecord record;
};

/// Runs work units of a plan. Safe to use from several threads: immutable after construction.
class Worker {
  public:
    /// @param stop  once true, `carry_out` throws `Interrupted`; null: never
    explicit Worker(const StudyPlan& plan, const std::atomic<bool>* stop = nullptr);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// A pure function of plan and unit, whether or not some of its trials exist already. @throws Interrupted
    [[nodiscard]] UnitRecord carry_out(const WorkUnit& unit, BegunUnit begun = {}) const;

  private:
    struct Tools;  // scene, tracer and points of one cell
    const StudyPlan& plan_;
    std::vector<std::unique_ptr<Tools>> tools_;
};

}  // namespace ff::studies
