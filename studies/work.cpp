#include "studies/work.hpp"

#include "core/area_kernel.hpp"
#include "core/error.hpp"
#include "core/exact.hpp"
#include "core/point_to_polygon.hpp"
#include "core/ray_shooting.hpp"
#include "core/tracer.hpp"
#include "samplers/sampler.hpp"

#include <fmt/format.h>

#include <bit>

namespace ff::studies {
namespace {

void add_matrix(const Eigen::MatrixXd& factors, std::uint64_t trial, UnitRecord& record) {
    for (int i = 0; i < factors.rows(); ++i) {
        for (int j = 0; j < factors.cols(); ++j) {
            if (i != j) record.observations.push_back({observable::estimate, i + 1, j + 1, trial, factors(i, j)});
        }
    }
}

void add_tally(const RayTally& tally, std::uint64_t trial, UnitRecord& record) {
    const std::size_t faces = tally.rays.size();
    for (std::size_t i = 0; i < faces; ++i) {
        const int from = static_cast<int>(i) + 1;
        record.observations.push_back({observable::rays, from, 0, trial, static_cast<std::int64_t>(tally.rays[i])});
        if (tally.lost[i] != 0) {
            record.observations.push_back({observable::lost, from, 0, trial, static_cast<std::int64_t>(tally.lost[i])});
        }
        for (std::size_t j = 0; j < faces; ++j) {
            if (i == j) continue;
            const auto hits = static_cast<std::int64_t>(tally.hits[i * faces + j]);
            record.observations.push_back({observable::hits, from, static_cast<int>(j) + 1, trial, hits});
        }
    }
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
    std::unique_ptr<Tracer> tracer;
    std::unique_ptr<PointSource> points;
};

Worker::Worker(const StudyPlan& plan, const std::atomic<bool>* stop) : plan_(plan) {
    for (const Cell& cell : plan.cells) {
        auto tools = std::make_unique<Tools>();
        tools->scene = &plan.scenes[cell.scene];
        tools->method = &plan.spec.methods[cell.method];
        tools->points = make_points(*tools->method, cell);
        if (tools->points && stop != nullptr) tools->points = interruptible(std::move(tools->points), *stop);
        if (tools->method->estimator == Estimator::ray_shooting) {
            tools->tracer = make_tracer(*tools->scene, tools->method->tracer);
        }
        tools_.push_back(std::move(tools));
    }
}

Worker::~Worker() = default;

UnitRecord Worker::carry_out(const WorkUnit& unit) const {
    const Cell& cell = plan_.cells[unit.cell];
    const Tools& tools = *tools_[unit.cell];
    UnitRecord record;
    record.unit = unit.index;
    PatchSums sums;
    PatchFactorSums factor_sums;
    RayTally tally;
    for (std::uint64_t trial = unit.first_trial; trial < unit.first_trial + unit.trials; ++trial) {
        const auto stream_trial = static_cast<std::uint32_t>(trial);
        switch (tools.method->estimator) {
            case Estimator::closed_form: {
                const auto factors = exact_form_factors(*tools.scene);
                if (!factors) {
                    throw UserError(fmt::format("method '{}': scene '{}' has no closed form. Use another estimator.",
                                                tools.method->name, tools.scene->name));
                }
                add_matrix(*factors, trial, record);
                break;
            }
            case Estimator::area_kernel:
                add_matrix(area_kernel(*tools.scene, cell.subdivision, *tools.points, tools.method->map, cell.key,
                                       stream_trial, &factor_sums),
                           trial, record);
                break;
            case Estimator::point_to_polygon:
                add_matrix(point_to_polygon(*tools.scene, cell.subdivision, *tools.points, cell.samples,
                                            tools.method->allocation, cell.key, stream_trial),
                           trial, record);
                break;
            case Estimator::ray_shooting:
                ray_shooting(*tools.scene, cell.subdivision, *tools.tracer, *tools.points, cell.samples,
                             tools.method->allocation, cell.key, stream_trial, tally, sums);
                add_tally(tally, trial, record);
                break;
        }
    }
    record.patch_hits = std::move(sums.hits);
    record.patch_hits_squared = std::move(sums.hits_squared);
    // Records hold words: of doubles, their bits.
    for (const double sum : factor_sums.factors) record.patch_hits.push_back(std::bit_cast<std::uint64_t>(sum));
    for (const double sum : factor_sums.factors_squared)
        record.patch_hits_squared.push_back(std::bit_cast<std::uint64_t>(sum));
    return record;
}

}  // namespace ff::studies
