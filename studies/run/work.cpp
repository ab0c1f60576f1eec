#include "studies/run/work.hpp"

#include "core/estimators/estimator.hpp"
#include "core/patches/face_averages.hpp"
#include "core/support/processor_time.hpp"
#include "core/visibility/facing.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// Whether a pair of faces is observed: of a face with itself only where it sees itself.
using Observed = std::vector<bool>;  // one for each face

void add_matrix(const Eigen::MatrixXd& values, std::string_view observable, const Observed& with_itself,
                std::uint64_t trial, UnitRecord& record) {
    for (int i = 0; i < values.rows(); ++i) {
        for (int j = 0; j < values.cols(); ++j) {
            if (i != j || with_itself[static_cast<std::size_t>(i)])
                record.observations.push_back({observable, i + 1, j + 1, trial, values(i, j)});
        }
    }
}

void add_rays(const RayTally& tally, std::size_t face, std::uint64_t trial, UnitRecord& record) {
    const auto add = [&](std::string_view observable, std::uint64_t count) {
        record.observations.push_back(
            {observable, static_cast<int>(face) + 1, 0, trial, static_cast<std::int64_t>(count)});
    };
    add(observable::rays, tally.rays[face]);
    if (tally.lost[face] != 0) add(observable::lost, tally.lost[face]);
}

void add_tally(const RayTally& tally, const Observed& with_itself, std::uint64_t trial, UnitRecord& record) {
    const std::size_t faces = tally.rays.size();
    for (std::size_t i = 0; i < faces; ++i) {
        add_rays(tally, i, trial, record);
        for (std::size_t j = 0; j < faces; ++j) {
            if (i == j && !with_itself[i]) continue;
            const auto hits = static_cast<std::int64_t>(tally.hits[i * faces + j]);
            record.observations.push_back(
                {observable::hits, static_cast<int>(i) + 1, static_cast<int>(j) + 1, trial, hits});
        }
    }
}

/// Records hold words: for doubles, their bits.
std::vector<double> as_doubles(const std::vector<std::uint64_t>& words) {
    std::vector<double> doubles;
    for (const std::uint64_t word : words) doubles.push_back(std::bit_cast<double>(word));
    return doubles;
}

/// The sums of the trials of a unit that was begun, moved out of their record.
PatchTotals begun_totals(UnitRecord& record, PatchFactors patch_factors) {
    PatchTotals totals;
    if (patch_factors == PatchFactors::rays) {
        totals.hits = {std::move(record.patch_hits), std::move(record.patch_hits_squared)};
    } else {
        totals.factors = {as_doubles(record.patch_hits), as_doubles(record.patch_hits_squared)};
        record.patch_hits.clear();
        record.patch_hits_squared.clear();
    }
    return totals;
}

/// A trial can take hours, and estimators need not know about stopping.
class InterruptiblePoints : public PointSource {
  public:
    InterruptiblePoints(std::unique_ptr<PointSource> points, const std::atomic<bool>& stop)
        : points_(std::move(points)), stop_(stop) {}

    [[nodiscard]] std::uint64_t points() const override { return points_->points(); }
    [[nodiscard]] bool randomised() const override { return points_->randomised(); }
    [[nodiscard]] bool equal_weights() const override { return points_->equal_weights(); }
    [[nodiscard]] bool exchangeable() const override { return points_->exchangeable(); }
    void checkpoint() const override {
        if (stop_.load(std::memory_order_relaxed)) throw Interrupted{};
    }
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        checkpoint();
        points_->fill(stream, first, block);
    }
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
        checkpoint();
        points_->fill(stream, first, block);
    }

  private:
    std::unique_ptr<PointSource> points_;
    const std::atomic<bool>& stop_;
};

}  // namespace

std::unique_ptr<PointSource> make_points(const Method& method, const Cell& cell, const std::atomic<bool>* stop) {
    if (method.sampler.empty()) return nullptr;
    const Nodes nodes = method.nodes.value_or(Nodes{});
    const std::uint64_t points = points_per_sequence(method, cell.subdivision, cell.samples_per_patch);
    auto made = samplers::find(method.sampler)
                    .make({points, estimator_info(method).dimension, nodes.source, nodes.target, cell.key});
    if (stop == nullptr) return made;
    return std::make_unique<InterruptiblePoints>(std::move(made), *stop);
}

struct Worker::Tools {
    const Scene* scene = nullptr;
    const Method* method = nullptr;
    std::shared_ptr<const Estimator> estimator;
    std::unique_ptr<PointSource> points;
    Observed with_itself;
    PatchFactors patch_factors = PatchFactors::none;
    bool counts_hits = false;
};

Worker::Worker(const StudyPlan& plan, const std::atomic<bool>* stop) : plan_(plan) {
    // Prepared once per scene: tracers may be large.
    std::map<std::tuple<std::size_t, std::string_view, TracerChoice>, std::shared_ptr<const Estimator>> estimators;
    for (const Cell& cell : plan.cells) {
        auto tools = std::make_unique<Tools>();
        tools->scene = &plan.scenes[cell.scene];
        tools->method = &plan.spec.methods[cell.method];
        tools->points = make_points(*tools->method, cell, stop);
        const EstimatorEntry& entry = find_estimator(tools->method->estimator);
        auto& estimator = estimators[{cell.scene, entry.info.name, tools->method->tracer}];
        if (!estimator) estimator = entry.make(*tools->scene, tools->method->tracer);
        tools->estimator = estimator;
        tools->patch_factors = entry.info.patch_factors;
        tools->counts_hits = entry.info.observes == Observes::hits && has_one_surface_a_face(*tools->scene);
        for (int face = 0; face < static_cast<int>(plan.scenes.faces(cell.scene).size()); ++face)
            tools->with_itself.push_back(sees_itself(*tools->scene, face));
        tools_.push_back(std::move(tools));
    }
}

Worker::~Worker() = default;

UnitRecord Worker::carry_out(const WorkUnit& unit, BegunUnit begun) const {
    const Cell& cell = plan_.cells[unit.cell];
    const Tools& tools = *tools_[unit.cell];
    UnitRecord record = std::move(begun.record);
    record.unit = unit.index;
    PatchTotals totals = begun_totals(record, tools.patch_factors);
    Outcome outcome;
    EstimatorTask task{.subdivision = cell.subdivision,
                       .points = tools.points.get(),
                       .samples = cell.samples_per_patch,
                       .options = estimator_options(*tools.method),
                       .key = cell.key};
    std::vector<double> times;
    for (std::uint64_t trial = unit.first_trial + begun.trials; trial < unit.first_trial + unit.trials; ++trial) {
        task.trial = static_cast<std::uint32_t>(trial);
        const double begin = processor_seconds();
        tools.estimator->observe(task, outcome, totals);
        times.push_back(processor_seconds() - begin);
        if (tools.counts_hits) {
            add_tally(outcome.rays, tools.with_itself, trial, record);
        } else {
            for (std::size_t face = 0; face < outcome.rays.rays.size(); ++face)
                add_rays(outcome.rays, face, trial, record);
            add_matrix(outcome.estimates, observable::estimate, tools.with_itself, trial, record);
            add_matrix(outcome.claims, observable::claim, tools.with_itself, trial, record);
        }
    }
    // The first trial of a unit also fills the caches: it counts no more than the second.
    if (times.size() > 1) times[0] = std::min(times[0], times[1]);
    for (const double seconds : times) {
        record.processor_seconds += seconds;
        record.processor_seconds_squared += seconds * seconds;
    }
    record.patch_hits = std::move(totals.hits.hits);
    record.patch_hits_squared = std::move(totals.hits.hits_squared);
    for (const double sum : totals.factors.factors) record.patch_hits.push_back(std::bit_cast<std::uint64_t>(sum));
    for (const double sum : totals.factors.factors_squared)
        record.patch_hits_squared.push_back(std::bit_cast<std::uint64_t>(sum));
    return record;
}

}  // namespace ff::studies
