#include "studies/run/run.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "studies/run/work.hpp"
#include "studies/trials/until.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ff::studies {
namespace {

/// Hands out units to threads and their records back to the thread that saves them.
class Workshop {
  public:
    /// No more threads than units.
    Workshop(const Worker& worker, std::vector<const WorkUnit*> units, const RunOptions& options)
        : worker_(worker), units_(std::move(units)), options_(options) {
        const std::size_t wanted =
            std::min<std::size_t>(options.threads, units_.size()) + (options.others ? std::size_t{1} : 0);
        active_ = wanted;
        try {
            if (options.others) {
                start([this] { options_.others([this](UnitRecord record) { return put(std::move(record)); }); });
            }
            while (threads_.size() < wanted) start([this] { work(); });
        } catch (const std::system_error& error) {
            const std::size_t started = threads_.size();
            end();
            throw UserError("{} threads (the system started {} of them: {}). Take fewer with --threads.", wanted,
                            started, error.code().message());
        }
    }

    ~Workshop() { end(); }

    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    /// The next finished record; empty when all threads are done. @throws what a unit threw
    std::optional<UnitRecord> take() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !records_.empty() || active_ == 0 || failure_; });
        if (failure_) std::rethrow_exception(failure_);
        if (records_.empty()) return std::nullopt;
        UnitRecord record = std::move(records_.front());
        records_.pop_front();
        changed_.notify_all();
        return record;
    }

  private:
    [[nodiscard]] bool is_to_stop() const { return options_.stop != nullptr && options_.stop->load(); }

    void end() {
        {
            const std::lock_guard lock(mutex_);
            cancelled_ = true;
        }
        changed_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

    /// Runs `job` on a thread; what it throws goes to `take`.
    template <typename Job>
    void start(Job job) {
        threads_.emplace_back([this, job] {
            std::exception_ptr failure;
            try {
                job();
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(mutex_);
            if (failure) failure_ = failure;
            --active_;
            changed_.notify_all();
        });
    }

    void wait_for_room(std::unique_lock<std::mutex>& lock) {
        changed_.wait(lock, [this] { return records_.size() < units_waiting(options_.threads) || cancelled_; });
    }

    bool put(UnitRecord record) {
        std::unique_lock lock(mutex_);
        wait_for_room(lock);
        if (cancelled_) return false;
        records_.push_back(std::move(record));
        changed_.notify_all();
        return true;
    }

    /// The next unit, when there is room for its record; null at the end.
    const WorkUnit* next() {
        std::unique_lock lock(mutex_);
        wait_for_room(lock);
        return cancelled_ || is_to_stop() || failure_ || next_ == units_.size() ? nullptr : units_[next_++];
    }

    void work() {
        try {
            while (const WorkUnit* unit = next()) {
                UnitRecord record = worker_.carry_out(*unit);
                const std::lock_guard lock(mutex_);
                records_.push_back(std::move(record));
                changed_.notify_all();
            }
        } catch (const Interrupted&) {
            // When the study is run again, it repeats the interrupted unit.
        }
    }

    const Worker& worker_;
    std::vector<const WorkUnit*> units_;
    const RunOptions& options_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<UnitRecord> records_;
    std::exception_ptr failure_;
    std::size_t next_ = 0;
    std::size_t active_ = 0;
    bool cancelled_ = false;
    std::vector<std::thread> threads_;
};

/// Units of the shard that are wanted and not finished yet.
std::vector<const WorkUnit*> missing_units(const StudyPlan& plan, const std::vector<bool>& finished,
                                           const std::vector<bool>& wanted, const RunOptions& options) {
    std::vector<const WorkUnit*> missing;
    for (const WorkUnit& unit : plan.units) {
        const bool ours = wanted[unit.index] && options.shard.holds(unit.index);
        if (ours && !finished[unit.index]) missing.push_back(&unit);
    }
    return missing;
}

/// The missing units that this process carries out.
std::vector<const WorkUnit*> own_units(const std::vector<const WorkUnit*>& missing, const RunOptions& options) {
    std::vector<const WorkUnit*> own;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (options.process.holds(i)) own.push_back(missing[i]);
    }
    return own;
}

/// Counts what is wanted and what of it is done. @param before  units that were finished when the run began
void count_units(const StudyPlan& plan, const std::vector<bool>& finished, const std::vector<bool>& wanted,
                 const std::vector<bool>& before, const RunOptions& options, RunProgress& progress, Pace& pace) {
    progress.units = progress.units_done = 0;
    pace.begin_round();
    for (const WorkUnit& unit : plan.units) {
        if (!wanted[unit.index] || !options.shard.holds(unit.index)) continue;
        ++progress.units;
        if (finished[unit.index]) ++progress.units_done;
        pace.count(unit, finished[unit.index], before[unit.index]);
    }
}

void run_round(Store& store, const Worker& worker, const std::vector<const WorkUnit*>& missing,
               const RunOptions& options, RunProgress& progress, Pace& pace) {
    const StudyPlan& plan = store.plan();
    Workshop workshop(worker, own_units(missing, options), options);
    while (const auto record = workshop.take()) {
        store.commit(*record);
        const WorkUnit& unit = plan.units[record->unit];
        ++progress.units_done;
        pace.finish(unit, record->processor_seconds);
        progress.seconds = pace.seconds();
        progress.evaluations += unit.trials * evaluations_per_trial(plan, plan.cells[unit.cell]);
        progress.unit = unit.index;
        progress.processor_seconds = record->processor_seconds;
        progress.processor_seconds_squared = record->processor_seconds_squared;
        if (options.report) options.report(progress);
    }
}

}  // namespace

RunOutcome run_study(Store& store, const RunOptions& options) {
    FF_EXPECT(options.threads >= 1);
    const StudyPlan& plan = store.plan();
    const Worker worker(plan, options.drop);
    RunProgress progress;
    Pace pace(plan);
    const std::vector<bool> before = store.finished_units();
    // An adaptive study has two rounds: what the second needs is known when the first is saved. Others have one, in
    // which other processes are waited for even where nothing is missing.
    for (bool first = true;; first = false) {
        const std::vector<bool> finished = store.finished_units();
        const std::vector<bool> wanted = needed_units(store);
        const auto missing = missing_units(plan, finished, wanted, options);
        if (missing.empty() && !first) return RunOutcome::complete;
        count_units(plan, finished, wanted, before, options, progress, pace);
        run_round(store, worker, missing, options, progress, pace);
        if (progress.units_done < progress.units) return RunOutcome::stopped;
        if (!plan.spec.until) return RunOutcome::complete;
    }
}

void carry_out_units(const StudyPlan& plan, const std::vector<bool>& finished, const RunOptions& options,
                     const std::function<void(const UnitRecord&)>& hand_over) {
    FF_EXPECT(!plan.spec.until);
    const Worker worker(plan, options.drop);
    const std::vector<bool> all(plan.units.size(), true);
    Workshop workshop(worker, own_units(missing_units(plan, finished, all, options), options), options);
    while (const auto record = workshop.take()) hand_over(*record);
}

}  // namespace ff::studies
