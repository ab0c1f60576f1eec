#include "core/estimators/patch_pairs.hpp"

#include "core/patches/patch_order.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace ff {
namespace {

/// One pair of patches with all its points.
double sum_over_points(const PatchPair& pair, const PointSource& points, const Stream& stream, const PairSum& sum,
                       WeightedBlock& block) {
    double total = 0;
    const std::uint64_t count = points.points();
    for (std::uint64_t first = 0; first < count; first += block.size) {
        block.size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, count - first));
        points.fill(stream, first, block);
        total += sum(pair, block);
    }
    return total;
}

PatchView view(const Surface& surface, const SurfaceMap& map, Grid grid, std::uint32_t patch) {
    return {&surface, &map, grid, patch % grid.columns, patch / grid.columns, area(surface.shape) / grid.parts()};
}

}  // namespace

Eigen::MatrixXd average_over_pairs(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                   const PairSum& sum, PairsOf pairs) {
    const PatchOrder order(scene, task.subdivision);
    std::vector<SurfaceMap> maps;
    for (const Surface& surface : scene.surfaces) maps.emplace_back(surface);
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = dimension;
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    Stream stream{.key = task.key, .trial = task.trial};
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& from = scene.surfaces[i];
        if (!is_of_face(from)) continue;
        const Grid from_grid = task.subdivision.of(from);
        for (std::uint32_t j = 0; j < scene.surfaces.size(); ++j) {
            const Surface& to = scene.surfaces[j];
            if (!is_of_face(to) || !face_each_other(from, to)) continue;
            const Grid to_grid = task.subdivision.of(to);
            std::vector<const Surface*> blockers;
            if (!scene.empty_box) blockers = possible_blockers(scene, from, to);
            if (pairs == PairsOf::occluded && blockers.empty()) continue;
            double exchange = 0;
            for (std::uint32_t p = 0; p < from_grid.parts(); ++p) {
                stream.source = order.first(i) + p;
                for (std::uint32_t q = 0; q < to_grid.parts(); ++q) {
                    stream.target = order.first(j) + q + 1;
                    task.points->checkpoint();
                    const PatchPair pair{view(from, maps[i], from_grid, p), view(to, maps[j], to_grid, q), &blockers};
                    exchange += pair.from.area * sum_over_points(pair, *task.points, stream, sum, *block);
                }
            }
            result(from.face, to.face) += exchange / face_area(scene, from.face);
        }
    }
    return result;
}

bool has_polygonal_faces(const Scene& scene) {
    return std::all_of(scene.surfaces.begin(), scene.surfaces.end(), [](const Surface& surface) {
        return !is_of_face(surface) || std::holds_alternative<Parallelogram>(surface.shape) ||
               std::holds_alternative<Triangle>(surface.shape);
    });
}

std::string refuse_curved_faces(std::string_view estimator, const Scene& scene) {
    if (has_polygonal_faces(scene)) return {};
    return fmt::format(
        "{} cannot be used in scene '{}' (not all of its faces are parallelograms and triangles). Use estimator = "
        "\"ray_shooting\" or \"area_kernel\".",
        estimator, scene.name);
}

}  // namespace ff
