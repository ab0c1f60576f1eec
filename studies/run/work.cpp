#include "studies/run/work.hpp"

#include "core/estimators/area_kernel.hpp"
#include "core/estimators/point_to_polygon.hpp"
#include "core/estimators/ray_shooting.hpp"
#include "core/exact/exact.hpp"
#include "core/patches/face_averages.hpp"
#include "core/support/error.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/facing.hpp"
#include "samplers/sampler.hpp"

#include <fmt/format.h>

#include <bit>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// Whether a pair of faces is observed: of a face with itself only where it sees itself.
using Observed = std::vector<bool>;  // by face

void add_matrix(const Eigen::MatrixXd& factors, const Observed& with_itself, std::uint64_t trial, UnitRecord& record) {
    for (int i = 0; i < factors.rows(); ++i) {
        for (int j = 0; j < factors.cols(); ++j) {
            if (i != j || with_itself[static_cast<std::size_t>(i)])
                record.observations.push_back({observable::estimate, i + 1, j + 1, trial, factors(i, j)});
        }
    }
}

void add_rays(const RayTally& tally, std::uint64_t trial, UnitRecord& record) {
    for (std::size_t i = 0; i < tally.rays.size(); ++i) {
        const int from = static_cast<int>(i) + 1;
        record.observations.push_back({observable::rays, from, 0, trial, static_cast<std::int64_t>(tally.rays[i])});
        if (tally.lost[i] != 0) {
            record.observations.push_back({observable::lost, from, 0, trial, static_cast<std::int64_t>(tally.lost[i])});
        }
    }
}

/// Whether sums of every patch are kept: of more numbers than this a unit of work would be too large to save.
bool keeps_patches(const Scene& scene, Subdivision subdivision) {
    constexpr std::uint64_t most = 1u << 22;
    return subdivision.patches(scene) * scene.faces.size() <= most;
}

void add_tally(const RayTally& tally, const Observed& with_itself, std::uint64_t trial, UnitRecord& record) {
    const std::size_t faces = tally.rays.size();
    for (std::size_t i = 0; i < faces; ++i) {
        const int from = static_cast<int>(i) + 1;
        record.observations.push_back({observable::rays, from, 0, trial, static_cast<std::int64_t>(tally.rays[i])});
        if (tally.lost[i] != 0) {
            record.observations.push_back({observable::lost, from, 0, trial, static_cast<std::int64_t>(tally.lost[i])});
        }
        for (std::size_t j = 0; j < faces; ++j) {
            if (i == j && !with_itself[i]) continue;
            const auto hits = static_cast<std::int64_t>(tally.hits[i * faces + j]);
            record.observations.push_back({observable::hits, from, static_cast<int>(j) + 1, trial, hits});
        }
    }
}

/// Records hold words: of doubles, their bits.
std::vector<double> as_doubles(const std::vector<std::uint64_t>& words) {
    std::vector<double> doubles;
    for (const std::uint64_t word : words) doubles.push_back(std::bit_cast<double>(word));
    return doubles;
}

}  // namespace

std::unique_ptr<PointSource> make_points(const Method& method, const Cell& cell) {
    if (method.sampler.empty()) return nullptr;
    const Nodes nodes = method.nodes.value_or(Nodes{});
    const std::uint64_t points = points_per_sequence(method, cell.subdivision, cell.samples);
    return samplers::find(method.sampler).make({points, dimension(method.estimator), nodes.source, nodes.target});
}

struct Worker::Tools {
    const Scene* scene = nullptr;
    const Method* method = nullptr;
    std::shared_ptr<const Tracer> tracer;
    std::unique_ptr<PointSource> points;
    Observed with_itself;
    bool counts_hits = false;
};

Worker::Worker(const StudyPlan& plan, const std::atomic<bool>* stop) : plan_(plan) {
    std::map<std::pair<std::size_t, TracerChoice>, std::shared_ptr<const Tracer>> tracers;
    for (const Cell& cell : plan.cells) {
        auto tools = std::make_unique<Tools>();
        tools->scene = &plan.scenes[cell.scene];
        tools->method = &plan.spec.methods[cell.method];
        tools->points = make_points(*tools->method, cell);
        if (tools->points && stop != nullptr) tools->points = interruptible(std::move(tools->points), *stop);
        if (tools->method->estimator == Estimator::ray_shooting) {
            auto& tracer = tracers[{cell.scene, tools->method->tracer}];
            if (!tracer) tracer = make_tracer(*tools->scene, tools->method->tracer);
            tools->tracer = tracer;
        }
        tools->counts_hits = has_one_surface_a_face(*tools->scene);
        for (int face = 0; face < static_cast<int>(tools->scene->faces.size()); ++face)
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
    PatchSums sums;
    PatchFactorSums factor_sums;
    if (tools.method->estimator == Estimator::ray_shooting) {
        sums = {std::move(record.patch_hits), std::move(record.patch_hits_squared)};
    } else {
        factor_sums = {as_doubles(record.patch_hits), as_doubles(record.patch_hits_squared)};
        record.patch_hits.clear();
        record.patch_hits_squared.clear();
    }
    RayTally tally;
    for (std::uint64_t trial = unit.first_trial + begun.trials; trial < unit.first_trial + unit.trials; ++trial) {
        const auto stream_trial = static_cast<std::uint32_t>(trial);
        switch (tools.method->estimator) {
            case Estimator::closed_form: {
                const auto factors = exact_form_factors(*tools.scene);
                if (!factors) {
                    throw UserError(fmt::format("method '{}': scene '{}' has no closed form. Use another estimator.",
                                                tools.method->name, tools.scene->name));
                }
                add_matrix(*factors, tools.with_itself, trial, record);
                break;
            }
            case Estimator::area_kernel:
                add_matrix(area_kernel(*tools.scene, cell.subdivision, *tools.points, tools.method->map, cell.key,
                                       stream_trial, &factor_sums),
                           tools.with_itself, trial, record);
                break;
            case Estimator::point_to_polygon:
                add_matrix(point_to_polygon(*tools.scene, cell.subdivision, *tools.points, cell.samples,
                                            tools.method->allocation, cell.key, stream_trial),
                           tools.with_itself, trial, record);
                break;
            case Estimator::ray_shooting:
                ray_shooting(*tools.scene, cell.subdivision, *tools.tracer, *tools.points, cell.samples,
                             tools.method->allocation, cell.key, stream_trial, tally,
                             keeps_patches(*tools.scene, cell.subdivision) ? &sums : nullptr);
                if (tools.counts_hits) {
                    add_tally(tally, tools.with_itself, trial, record);
                } else {
                    add_rays(tally, trial, record);
                    add_matrix(face_averages(*tools.scene, tally.weighted, cell.subdivision.per_part() * cell.samples),
                               tools.with_itself, trial, record);
                }
                break;
        }
    }
    record.patch_hits = std::move(sums.hits);
    record.patch_hits_squared = std::move(sums.hits_squared);
    for (const double sum : factor_sums.factors) record.patch_hits.push_back(std::bit_cast<std::uint64_t>(sum));
    for (const double sum : factor_sums.factors_squared)
        record.patch_hits_squared.push_back(std::bit_cast<std::uint64_t>(sum));
    return record;
}

}  // namespace ff::studies
