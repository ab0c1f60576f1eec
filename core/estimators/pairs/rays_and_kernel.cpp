#include "core/estimators/pairs/rays_and_kernel.hpp"

#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/estimators/unmet.hpp"
#include "core/geometry/line_meets.hpp"
#include "core/geometry/unit_circle.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace ff {
namespace {

using Eigen::Vector3d;

/// How a place on the target was found.
enum class Way { ray, laid };

/// The contribution of a place on the target: the density of rays there over the density with which the place was
/// found, times the weight of that technique. 0 where the two places do not see each other.
double weighted(const PatchPair& pair, const SurfacePoint& from, const Vector3d& place, const Vector3d& normal,
                Heuristic heuristic, Way way) {
    const Vector3d apart = place - from.position;
    const double leaving = apart.dot(from.normal);
    const double arriving = -apart.dot(normal);
    if (!(leaving > 0 && arriving > 0)) return 0;
    if (!sees(from.position, *pair.from.surface, place, *pair.to.surface, *pair.blockers)) return 0;
    const double squared = apart.squaredNorm();
    // Densities, of rays and of places that are laid, times pi r^4.
    const double rays = leaving * arriving;
    const double laid = std::numbers::pi * squared * squared / pair.to.area;
    if (heuristic == Heuristic::balance) return rays / (rays + laid);
    const double p = rays / std::max(rays, laid);
    const double q = laid / std::max(rays, laid);
    return p * (way == Way::ray ? p : q) / (p * p + q * q);
}

bool is_on(const PatchView& patch, SurfaceCoordinates at) {
    const auto part = [](double coordinate, std::uint32_t parts) {
        return std::min(static_cast<std::uint32_t>(coordinate * parts), parts - 1);
    };
    return part(at.s, patch.grid.columns) == patch.column && part(at.t, patch.grid.rows) == patch.row;
}

/// A place on the target and its normal.
struct Place {
    Vector3d position;
    Vector3d normal;
};

/// Where a cosine-distributed ray meets the target's patch.
std::optional<Place> shoot(const PatchPair& pair, const SurfacePoint& from, double s, double t) {
    const CirclePoint azimuth = unit_circle(t);
    const Vector3d across = from.normal.cross(from.tangent);
    const Vector3d direction =
        std::sqrt(s) * (azimuth.cosine * from.tangent + azimuth.sine * across) + std::sqrt(1 - s) * from.normal;
    const Line line{from.position, direction};
    const auto meeting = line_meets(line, *pair.to.surface, {.begins = pair.from.surface == pair.to.surface});
    if (!meeting) return std::nullopt;
    const Vector3d place = line.at(meeting->time);
    const Surface& surface = *pair.to.surface;
    if (is_flat(surface.shape) && pair.to.grid == undivided) return Place{place, surface.normal};
    const SurfaceCoordinates at = pair.to.map->coordinates(place);
    if (!is_on(pair.to, at)) return std::nullopt;
    return Place{place, pair.to.map->at(at.s, at.t).normal};
}

}  // namespace

double TwoWays::largest_unmet(const Scene& scene, int from, int to, double evaluations) {
    return largest_unmet_hit(scene, from, to, evaluations, RaysAndKernel::info.largest_value);
}

Eigen::MatrixXd TwoWays::estimate(const EstimatorTask& task, Heuristic heuristic) const {
    constexpr std::size_t dimension = RaysAndKernel::info.dimension;
    return average_over_pairs(scene(), task, dimension, [heuristic](const PatchPair& pair, const WeightedBlock& block) {
        double sum = 0;
        for (std::size_t i = 0; i < block.size; ++i) {
            const SurfacePoint from = pair.from.at(block.coordinate[0][i], block.coordinate[1][i]);
            const double s = block.coordinate[2][i];
            const double t = block.coordinate[3][i];
            const SurfacePoint laid = pair.to.at(s, t);
            double value = weighted(pair, from, laid.position, laid.normal, heuristic, Way::laid);
            if (const auto place = shoot(pair, from, s, t))
                value += weighted(pair, from, place->position, place->normal, heuristic, Way::ray);
            sum += block.weight[i] * value;
        }
        return sum;
    });
}

}  // namespace ff
