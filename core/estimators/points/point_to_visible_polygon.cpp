#include "core/estimators/points/point_to_visible_polygon.hpp"

#include "core/estimators/points/source_points.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace ff {

PointToVisiblePolygon::PointToVisiblePolygon(const Scene& scene, TracerChoice /*tracer*/)
    : scene_(&scene), targets_(scene.surfaces.size()) {
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
    return fmt::format(
        "{} cannot be used in scene '{}' (not all of its surfaces are parallelograms and triangles). Use estimator = "
        "\"ray_shooting\" or \"area_kernel\".",
        info.name, scene.name);
}

double PointToVisiblePolygon::nanoseconds(const EstimatorOptions& /*options*/, const Scene& scene) {
    return 200.0 * static_cast<double>(scene.faces.size());
}

std::optional<Integrand> PointToVisiblePolygon::integrand(const EstimatorOptions& /*options*/, PairClass pair_class,
                                                          Hiding hiding) {
    const bool kinks = pair_class == PairClass::adjacent || hiding == Hiding::possible;
    return kinks ? Integrand::rough : Integrand::smooth;
}

void PointToVisiblePolygon::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    std::vector<SurfaceMap> maps;
    for (const Surface& surface : scene_->surfaces) maps.emplace_back(surface);
    outcome.estimates = average_over_sources(
        *scene_, task, info.dimension,
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

}  // namespace ff
