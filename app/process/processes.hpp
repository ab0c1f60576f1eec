#pragma once

#include "studies/run/parallel.hpp"

#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace ff::app {

/// The processes that do a piece of work together: those that mpirun started, or this one alone. The first one leads:
/// it has the files, the others send it what they do. When a process ends with an exception the whole job ends, and
/// what the store holds is saved.
class Processes {
  public:
    Processes();
    ~Processes();  // NOLINT(performance-trivially-destructible): with MPI it has work to do
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;

    [[nodiscard]] bool alone() const { return part_.is_whole(); }
    [[nodiscard]] bool leads() const { return part_.index == 1; }
    /// This process's part of the work.
    [[nodiscard]] const studies::Shard& part() const { return part_; }

    /// Every process calls this once, and all receive what the leader passes.
    std::vector<bool> share_finished(std::vector<bool> finished) const;

    /// Called by processes other than the leader: does `work`, which sends messages, and returns when the leader has
    /// all messages of all processes. While it works, a request to stop here (app/process/signals.hpp) is passed on to
    /// all processes.
    void assist(const std::function<void()>& work) const;
    void send(std::span<const std::uint64_t> message) const;
    /// Called by the leader: delivers what the others send, until all have finished or `deliver` returns false, and
    /// passes requests to stop on to all of them. The only thread that communicates while it runs.
    void receive(const std::function<bool(std::span<const std::uint64_t>)>& deliver) const;

  private:
    studies::Shard part_;
    mutable std::mutex talking_;  ///< used by processes other than the leader, whose listener communicates too
};

}  // namespace ff::app
