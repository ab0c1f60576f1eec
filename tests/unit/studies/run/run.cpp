#include "studies/run/run.hpp"

#include "samplers/outside/added.hpp"
#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <numeric>
#include <thread>

namespace ff::studies {
namespace {

using test::plan_of;
using test::rows_of;
using test::study_text;

/// Every estimator, both tracers, unequal faces; 55 units, since every size is at least one.
StudyPlan mixed_plan() {
    std::string samples = "1";
    for (int n = 2; n <= 50; ++n) samples += ", " + std::to_string(n);
    return plan_of(
        "[study]\nname = \"t\"\nscene = \"box:2x1x0.5\"\ntrials = 3\nseed = 5\n"
        "[[method]]\nname = \"rays\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
        "patches_per_face = 4\nsamples_per_patch = [" +
        samples +
        "]\n[[method]]\nname = \"embree\"\nsampler = \"sobol\"\nestimator = \"ray_shooting\"\n"
        "tracer = \"embree\"\nallocation = \"face\"\npatches_per_face = 9\nsamples_per_patch = [16, 64]\n"
        "[[method]]\nname = \"kernel\"\nsampler = \"halton\"\nestimator = \"area_kernel\"\n"
        "patches_per_face = 4\nsamples_per_patch = [2, 5]\n"
        "[[method]]\nname = \"exact\"\nestimator = \"closed_form\"\n");
}

class Run : public testing::Test {
  protected:
    std::filesystem::path file(std::string_view name) const { return folder.path() / name; }
    test::TemporaryFolder folder;
};

TEST_F(Run, GivesTheSameRowsForAnyNumberOfThreads) {
    const StudyPlan plan = mixed_plan();
    for (const unsigned threads : {1u, 2u, 3u}) test::run(plan, file(std::to_string(threads)), threads);
    const auto rows = rows_of(file("1"));
    EXPECT_GT(rows.size(), 5000u);
    EXPECT_EQ(rows_of(file("2")), rows);
    EXPECT_EQ(rows_of(file("3")), rows);
}

TEST_F(Run, GivesOtherRowsForAnotherSeed) {
    StudyPlan plan = mixed_plan();
    test::run(plan, file("a"));
    StudySpec other = plan.spec;
    other.seed = Seed{6};
    test::run(plan_study(other), file("b"));
    EXPECT_NE(rows_of(file("a")), rows_of(file("b")));
}

TEST_F(Run, ResumesAfterAStopAtAnyUnit) {
    const StudyPlan plan = mixed_plan();
    test::run(plan, file("whole"));
    const auto rows = rows_of(file("whole"));
    for (const std::size_t units : {std::size_t{1}, std::size_t{20}, plan.units.size() - 1}) {
        const auto stopped = file("stopped" + std::to_string(units));
        {
            Store store = Store::create_or_resume(stopped, plan);
            std::atomic<bool> stop{false};
            RunOptions options;
            options.stop = &stop;
            options.report = [&](const RunProgress& progress) { stop = progress.units_done >= units; };
            const auto outcome = run_study(store, options);
            const auto done = store.finished_units();
            EXPECT_GE(std::accumulate(done.begin(), done.end(), std::size_t{0}), units);
            EXPECT_EQ(outcome == RunOutcome::complete,
                      std::accumulate(done.begin(), done.end(), std::size_t{0}) == done.size());
        }
        test::run(plan, stopped, 2);
        EXPECT_EQ(rows_of(stopped), rows);
    }
}

TEST_F(Run, DoesNothingWhenAllIsDone) {
    const StudyPlan plan = mixed_plan();
    Store store = test::run(plan);
    RunOptions options;
    options.report = [](const RunProgress&) { FAIL() << "a unit was done again"; };
    EXPECT_EQ(run_study(store, options), RunOutcome::complete);
}

TEST_F(Run, StopsAtOnceOnRequest) {
    const std::atomic<bool> stop{true};
    RunOptions options;
    options.stop = &stop;
    Store store = Store::create_or_resume(test::in_memory, mixed_plan());
    EXPECT_EQ(run_study(store, options), RunOutcome::stopped);
    const auto done = store.finished_units();
    EXPECT_EQ(std::count(done.begin(), done.end(), true), 0);
}

TEST_F(Run, KeepsOnlyAFewUnitsInMemoryWhileTheDiskIsSlow) {
    constexpr unsigned threads = 2;
    Store store = Store::create_or_resume(test::in_memory, mixed_plan());
    std::atomic<bool> stop{false};
    RunOptions options;
    options.threads = threads;
    options.stop = &stop;
    // Nothing is taken from the threads while the first report lasts: they could do all 55 units in a tenth of it.
    options.report = [&](const RunProgress&) {
        if (stop) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop = true;
    };
    EXPECT_EQ(run_study(store, options), RunOutcome::stopped);
    const auto done = store.finished_units();
    const auto saved = static_cast<std::size_t>(std::count(done.begin(), done.end(), true));
    EXPECT_LE(saved, 1u + (2 * threads + 2) + 2 * threads);  // reported + waiting + in hand
}

/// Holds every trial but the first from its first point on, until it is opened. The sampler stays known by its name,
/// but no other test asks for it.
class Gate {
  public:
    /// A sampler whose points wait here. Its units have one trial each: a point is said to cost a second.
    void add_as(std::string name) {
        samplers::SamplerInfo traits;
        traits.nanoseconds = 1e9;
        samplers::add(std::make_unique<samplers::AddedSampler>(
            samplers::AddedSampler::Texts{std::move(name), "", ""}, traits, std::vector<std::uint64_t>(),
            [this](const samplers::PointSetSpec& spec) { return std::make_unique<Points>(*this, spec); }));
    }

    void wait_until_a_trial_is_held() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return held_; });
    }

    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

  private:
    class Points : public PointSource {
      public:
        Points(Gate& gate, const samplers::PointSetSpec& spec)
            : gate_(gate), points_(samplers::find("random").make(spec)) {}
        [[nodiscard]] std::uint64_t points() const override { return points_->points(); }
        [[nodiscard]] bool randomised() const override { return true; }
        [[nodiscard]] bool equal_weights() const override { return true; }
        void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
            gate_.pass(stream.trial);
            points_->fill(stream, first, block);
        }
        void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
            gate_.pass(stream.trial);
            points_->fill(stream, first, block);
        }

      private:
        Gate& gate_;
        std::unique_ptr<PointSource> points_;
    };

    void pass(std::uint32_t trial) {
        if (trial == 0) return;
        std::unique_lock lock(mutex_);
        held_ = true;
        changed_.notify_all();
        changed_.wait(lock, [this] { return open_; });
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool held_ = false;
    bool open_ = false;
};

TEST_F(Run, FinishesCurrentUnitsUnlessToldToDropThem) {
    const auto units_saved = [](const std::string& sampler, bool drop) {
        Gate gate;
        gate.add_as(sampler);
        const StudyPlan plan =
            plan_of(study_text("trials = 3", "[[method]]\nname = \"a\"\nsampler = \"" + sampler +
                                                 "\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 10"));
        EXPECT_EQ(plan.units.size(), 3u);
        Store store = Store::create_or_resume(test::in_memory, plan);
        std::atomic<bool> stop{false};
        RunOptions options;
        options.stop = &stop;
        if (drop) options.drop = &stop;
        options.report = [&](const RunProgress&) {
            gate.wait_until_a_trial_is_held();
            stop = true;
            gate.open();
        };
        EXPECT_EQ(run_study(store, options), RunOutcome::stopped);
        const auto done = store.finished_units();
        return std::count(done.begin(), done.end(), true);
    };
    EXPECT_EQ(units_saved("held_points", false), 2);
    EXPECT_EQ(units_saved("held_points_to_drop", true), 1);
}

TEST_F(Run, StopsWithinATrialThatWouldTakeHours) {
    constexpr std::string_view rays =
        "sampler = \"random\"\nestimator = \"ray_shooting\"\npatches_per_face = 100\nsamples_per_patch = 4000000000";
    constexpr std::string_view kernel =
        "sampler = \"sobol\"\nestimator = \"area_kernel\"\npatches_per_face = 100\nsamples_per_patch = 100000000";
    constexpr std::string_view quadrature =
        "sampler = \"gauss_legendre\"\nnodes = 64\nestimator = \"area_kernel\"\npatches_per_face = 400";
    for (const std::string_view method : {rays, kernel, quadrature}) {
        Store store = Store::create_or_resume(
            test::in_memory, plan_of(study_text("trials = 2", "[[method]]\nname = \"a\"\n" + std::string(method))));
        std::atomic<bool> stop{false};
        RunOptions options;
        options.stop = &stop;
        options.drop = &stop;
        std::thread user([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            stop = true;
        });
        EXPECT_EQ(run_study(store, options), RunOutcome::stopped);
        user.join();
        const auto done = store.finished_units();
        EXPECT_EQ(std::count(done.begin(), done.end(), true), 0);
    }
}

TEST_F(Run, ReportsProgressThatGrowsToTheEnd) {
    Store store = Store::create_or_resume(test::in_memory, mixed_plan());
    std::vector<RunProgress> reports;
    RunOptions options;
    options.report = [&](const RunProgress& progress) { reports.push_back(progress); };
    run_study(store, options);
    ASSERT_EQ(reports.size(), store.plan().units.size());
    for (std::size_t i = 0; i < reports.size(); ++i) EXPECT_EQ(reports[i].units_done, i + 1);
    EXPECT_NEAR(reports.back().seconds.done, reports.back().seconds.all, 1e-9 * reports.back().seconds.all);
    EXPECT_EQ(reports.back().seconds.before, 0);
    std::uint64_t evaluations = 0;
    for (const Cell& cell : store.plan().cells) evaluations += cell.trials * evaluations_per_trial(store.plan(), cell);
    EXPECT_EQ(reports.back().evaluations, evaluations);
}

TEST_F(Run, GivesTheSameTrialsWhateverTheirNumber) {
    const auto plan = [](std::string_view trials) {
        return plan_of(study_text("trials = " + std::string(trials),
                                  "[[method]]\nname = \"a\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
                                  "samples_per_patch = 64"));
    };
    const Store few = test::run(plan("4"));
    const Store many = test::run(plan("9"));
    auto values = many.series(0, observable::hits, 1, 2).value;
    values.resize(4);
    EXPECT_EQ(few.series(0, observable::hits, 1, 2).value, values);
}

TEST_F(Run, GivesAMethodTheSameTrialsAloneAsAmongOthers) {
    const StudyPlan all = mixed_plan();
    StudySpec one = all.spec;
    one.methods.erase(one.methods.begin());
    const Store among = test::run(all);
    const Store alone = test::run(plan_study(one));
    for (std::size_t cell = 0; cell < alone.plan().cells.size(); ++cell) {
        const auto observable = cell < 2 ? observable::hits : observable::estimate;
        EXPECT_EQ(alone.series(cell, observable, 2, 3).value, among.series(cell + 50, observable, 2, 3).value);
    }
}

}  // namespace
}  // namespace ff::studies
