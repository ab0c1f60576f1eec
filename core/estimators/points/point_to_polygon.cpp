#include "core/estimators/points/point_to_polygon.hpp"

#include "core/formulas/polygon_factor.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ff {
namespace {

/// Coordinates in which a source surface lies in z = 0, radiates upwards, and has its corner at the origin.
struct SourceFrame {
    Eigen::Vector3d origin;
    Eigen::Matrix3d axes;  ///< rows

    explicit SourceFrame(const Surface& source) : origin(parallelogram(source).corner) {
        axes.row(0) = parallelogram(source).edge_u.normalized();
        axes.row(1) = source.normal.cross(parallelogram(source).edge_u).normalized();
        axes.row(2) = source.normal;
    }

    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& vector) const { return axes * vector; }
    [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector3d& point) const { return axes * (point - origin); }
};

/// A surface that a source sees some of.
struct SeenSurface {
    std::size_t surface = 0;
    Polygon polygon;  ///< its part above the horizon, in the frame of the source
};

/// A source, and what lies in front of it.
struct SeenFrom {
    std::uint32_t surface;
    SourceFrame frame;
    std::vector<SeenSurface> targets;

    SeenFrom(const Scene& scene, std::uint32_t source) : surface(source), frame(scene.surfaces[source]) {
        for (std::size_t t = 0; t < scene.surfaces.size(); ++t) {
            const Surface& target = scene.surfaces[t];
            if (target.face == no_face || !face_each_other(scene.surfaces[source], target)) continue;
            Polygon polygon = outline(target);
            for (Eigen::Vector3d& vertex : polygon) vertex = frame.point(vertex);
            targets.push_back({t, clip_at_horizon(polygon)});
        }
    }
};

/// Where a block of 2-D points lies on a patch.
void place(const SourceFrame& frame, const Parallelogram& patch, const WeightedBlock& block, PlanePoints& points) {
    const Eigen::Vector3d corner = frame.point(patch.corner);
    const Eigen::Vector3d edge_u = frame.direction(patch.edge_u);
    const Eigen::Vector3d edge_v = frame.direction(patch.edge_v);
    for (std::size_t i = 0; i < block.size; ++i) {
        const double u = block.coordinate[0][i];
        const double v = block.coordinate[1][i];
        points.x[i] = corner.x() + (u * edge_u.x() + v * edge_v.x());
        points.y[i] = corner.y() + (u * edge_u.y() + v * edge_v.y());
        points.weight[i] = block.weight[i];
    }
    points.size = (block.size + 7) / 8 * 8;
    for (std::size_t i = block.size; i < points.size; ++i) points.x[i] = points.y[i] = points.weight[i] = 0;
}

}  // namespace

Eigen::MatrixXd point_to_polygon(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                 std::uint64_t samples_per_patch, Allocation allocation, StreamKey key,
                                 std::uint32_t trial) {
    const EstimatorTask task{.subdivision = subdivision,
                             .points = &points,
                             .samples = samples_per_patch,
                             .options = {.allocation = allocation},
                             .key = key,
                             .trial = trial};
    const auto placed = std::make_unique_for_overwrite<PlanePoints>();
    std::optional<SeenFrom> source;
    return average_over_sources(
        scene, task, 2, [&](SourcePatch at, const WeightedBlock& block, std::span<double> sums) {
            if (!source || source->surface != at.surface) source.emplace(scene, at.surface);
            place(source->frame, patch(parallelogram(scene.surfaces[at.surface]), at.grid, at.index), block, *placed);
            for (const SeenSurface& target : source->targets)
                sums[target.surface] += sum_polygon_factors(*placed, target.polygon);
        });
}

std::string PointToPolygon::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    if (has_only_parallelograms(scene)) return {};
    return refused(info, scene, "not all of its surfaces are parallelograms");
}

void PointToPolygon::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates = point_to_polygon(scene(), task.subdivision, *task.points, task.samples, task.options.allocation,
                                         task.key, task.trial);
}

PointToVisiblePolygon::PointToVisiblePolygon(const Scene& scene, TracerChoice tracer)
    : SceneEstimator(scene, tracer), targets_(scene.surfaces.size()) {
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& source = scene.surfaces[s];
        if (!is_of_face(source)) continue;
        for (std::uint32_t t = 0; t < scene.surfaces.size(); ++t) {
            const Surface& target = scene.surfaces[t];
            if (!is_of_face(target) || !face_each_other(source, target)) continue;
            std::vector<Blocker> blockers;
            if (!scene.empty_box) {
                for (const Surface* blocker : possible_blockers(scene, source, target)) blockers.emplace_back(blocker);
            }
            targets_[s].push_back({t, VisiblePolygon(target, blockers)});
        }
    }
}

std::string PointToVisiblePolygon::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    const bool polygons = std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                                      [](const Surface& surface) { return is_polygon(surface.shape); });
    if (polygons) return {};
    return refused(info, scene, "not all of its surfaces are parallelograms and triangles");
}

void PointToVisiblePolygon::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    std::vector<SurfaceMap> maps;
    for (const Surface& surface : scene().surfaces) maps.emplace_back(surface);
    outcome.estimates = average_over_sources(
        scene(), task, info.dimension,
        [&](const SourcePatch& patch, const WeightedBlock& block, std::span<double> sums) {
            const auto columns = patch.grid.columns;
            for (std::size_t i = 0; i < block.size; ++i) {
                const auto column = patch.index % columns;
                const auto row = patch.index / columns;
                const SurfacePoint place = maps[patch.surface].at((column + block.coordinate[0][i]) / columns,
                                                                  (row + block.coordinate[1][i]) / patch.grid.rows);
                for (const Target& target : targets_[patch.surface]) {
                    const double factor = target.polygon.from(place.position, place.normal).visible;
                    sums[target.surface] += block.weight[i] * std::max(0.0, factor);
                }
            }
        });
}

Eigen::MatrixXd average_over_sources(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                     const SourceSum& sum) {
    FF_EXPECT(task.options.allocation == Allocation::patch || task.points->equal_weights());
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    const PatchSequences sequences(scene, task.subdivision, task.options.allocation, task.samples);
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = dimension;

    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    std::vector<double> sums(scene.surfaces.size());
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& source = scene.surfaces[s];
        if (!is_of_face(source)) continue;
        std::fill(sums.begin(), sums.end(), 0.0);
        const Grid grid = task.subdivision.of(source);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            const auto [of_stream, first] = sequences.of(s, p);
            const Stream stream{.key = task.key, .trial = task.trial, .source = of_stream};
            for_each_block(*task.points, stream, first, task.samples, *block, [&](PointIndex) {
                sum({s, grid, p}, *block, sums);
            });
        }
        // The weights of a sequence add up to 1, whether it serves a patch or several.
        const double share = area(source.shape) / face_area(scene, source.face) / sequences.count(s);
        for (std::size_t t = 0; t < sums.size(); ++t) {
            if (is_of_face(scene.surfaces[t])) result(source.face, scene.surfaces[t].face) += share * sums[t];
        }
    }
    return result;
}

}  // namespace ff
