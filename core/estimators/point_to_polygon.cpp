#include "core/estimators/point_to_polygon.hpp"

#include "core/formulas/polygon_factor.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
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

/// The corners of a surface, counter-clockwise as seen from the side of its normal.
Polygon corners(const Surface& surface) {
    const auto& [corner, edge_u, edge_v] = parallelogram(surface);
    Polygon polygon{corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v};
    if (edge_u.cross(edge_v).dot(surface.normal) < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// A surface that a source sees some of, and what has been summed for it.
struct Target {
    int face = 0;
    Polygon polygon;  ///< in the frame of the source, above its horizon
    double sum = 0;
};

std::vector<Target> visible_targets(const Scene& scene, const Surface& source, const SourceFrame& frame) {
    std::vector<Target> targets;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == no_face || !face_each_other(source, surface)) continue;
        Polygon polygon = corners(surface);
        for (Eigen::Vector3d& vertex : polygon) vertex = frame.point(vertex);
        targets.push_back({surface.face, clip_at_horizon(polygon)});
    }
    return targets;
}

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
    FF_EXPECT(allocation == Allocation::patch || points.equal_weights());
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    const PatchSequences sequences(scene, subdivision, allocation, samples_per_patch);
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    const auto placed = std::make_unique_for_overwrite<PlanePoints>();
    block->dimension = 2;

    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& source = scene.surfaces[s];
        if (source.face == no_face) continue;
        const SourceFrame frame(source);
        std::vector<Target> targets = visible_targets(scene, source, frame);
        const Grid grid = subdivision.of(source);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            const Parallelogram shape = patch(parallelogram(source), grid, p);
            const auto [of_stream, first] = sequences.of(s, p);
            const Stream stream{.key = key, .trial = trial, .source = of_stream};
            for (std::uint64_t done = 0; done < samples_per_patch; done += block->size) {
                block->size =
                    static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, samples_per_patch - done));
                points.fill(stream, first + done, *block);
                place(frame, shape, *block, *placed);
                for (Target& target : targets) target.sum += sum_polygon_factors(*placed, target.polygon);
            }
        }
        // The weights of a sequence add up to 1, whether it serves a patch or several.
        const double share = area(source.shape) / face_area(scene, source.face) / sequences.count(s);
        for (const Target& target : targets) result(source.face, target.face) += share * target.sum;
    }
    return result;
}

std::string PointToPolygon::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    if (has_only_parallelograms(scene)) return {};
    return fmt::format(
        "{} cannot be used in scene '{}' (not all of its surfaces are parallelograms). Use estimator = "
        "\"ray_shooting\" or \"area_kernel\".",
        info.name, scene.name);
}

double PointToPolygon::nanoseconds(const EstimatorOptions& /*options*/, const Scene& /*scene*/) {
    return 60.0;  // of all faces of a box
}

std::optional<Integrand> PointToPolygon::integrand(const EstimatorOptions& /*options*/, PairClass pair_class,
                                                   Hiding /*hiding*/) {
    return pair_class == PairClass::adjacent ? Integrand::rough : Integrand::smooth;
}

void PointToPolygon::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates = point_to_polygon(*scene_, task.subdivision, *task.points, task.samples, task.options.allocation,
                                         task.key, task.trial);
}

}  // namespace ff
