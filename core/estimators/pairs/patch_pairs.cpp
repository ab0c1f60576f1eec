#include "core/estimators/pairs/patch_pairs.hpp"

#include "core/patches/patch_order.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>

namespace ff {
namespace {

PatchView view(const Surface& surface, const SurfaceMap& map, Grid grid, std::uint32_t patch) {
    return {&surface, &map, grid, patch % grid.columns, patch / grid.columns, area(surface.shape) / grid.parts()};
}

}  // namespace

std::array<Eigen::Vector3d, 4> counter_clockwise(const PatchView& patch) {
    std::array<Eigen::Vector3d, 4> corners = patch.corners();
    const Eigen::Vector3d turn = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    if (turn.dot(patch.surface->normal) < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

PairAverages average_pair_values(const Scene& scene, const EstimatorTask& task, const PairValue& value, PairsOf pairs) {
    const PatchOrder order(scene, task.subdivision);
    std::vector<SurfaceMap> maps;
    for (const Surface& surface : scene.surfaces) maps.emplace_back(surface);
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    PairAverages result{Eigen::MatrixXd::Zero(faces, faces), Eigen::MatrixXd::Zero(faces, faces)};
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
            BoundedValue<double> exchange;
            for (std::uint32_t p = 0; p < from_grid.parts(); ++p) {
                stream.source = order.first(i) + p;
                for (std::uint32_t q = 0; q < to_grid.parts(); ++q) {
                    stream.target = order.first(j) + q + 1;
                    const PatchPair pair{view(from, maps[i], from_grid, p), view(to, maps[j], to_grid, q), &blockers};
                    const auto [factor, claim] = value(pair, stream);
                    exchange.value += pair.from.area * factor;
                    exchange.error += pair.from.area * claim;
                }
            }
            result.factors(from.face, to.face) += exchange.value / face_area(scene, from.face);
            result.claims(from.face, to.face) += exchange.error / face_area(scene, from.face);
        }
    }
    return result;
}

Eigen::MatrixXd average_over_pairs(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                   const PairSum& sum, PairsOf pairs) {
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = dimension;
    const auto value = [&](const PatchPair& pair, const Stream& stream) -> BoundedValue<double> {
        task.points->checkpoint();
        double total = 0;
        for_each_block(*task.points, stream, 0, task.points->points(), *block,
                       [&](PointIndex) { total += sum(pair, *block); });
        return {total, 0};
    };
    return average_pair_values(scene, task, value, pairs).factors;
}

}  // namespace ff
