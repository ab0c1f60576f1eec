#include "tests/validation/form_factors/plain_reference.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/moments.hpp"
#include "stats/means/mean_test.hpp"
#include "tests/support/plain_visible_polygon.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// Whether a surface lies behind the plane of an end, or beside the box around both: no line between them meets it.
bool is_out_of_the_way(const Surface& blocker, const Surface& end, const Eigen::AlignedBox3d& box) {
    const std::vector<Vector3d> corners = outline(blocker);
    const Vector3d origin = outline(end).front();
    const double room = 1e-12 * box.diagonal().norm();
    const auto all = [&](const auto& condition) { return std::all_of(corners.begin(), corners.end(), condition); };
    if (all([&](const Vector3d& corner) { return end.normal.dot(corner - origin) <= room; })) return true;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (all([&](const Vector3d& corner) { return corner[axis] <= box.min()[axis] + room; }) ||
            all([&](const Vector3d& corner) { return corner[axis] >= box.max()[axis] - room; }))
            return true;
    }
    return false;
}

std::vector<Blocker> blockers_between(const Scene& scene, const Surface& source, const Surface& target) {
    const Eigen::AlignedBox3d box = box_around(source).merged(box_around(target));
    std::vector<Blocker> blockers;
    for (const Surface& surface : scene.surfaces) {
        if (&surface == &source || &surface == &target) continue;
        if (is_out_of_the_way(surface, source, box) || is_out_of_the_way(surface, target, box)) continue;
        blockers.emplace_back(&surface);
    }
    return blockers;
}

PlainReference around(const std::vector<double>& means, double rounding, double level) {
    PlainReference result;
    result.value = *stats::moments_of(means).mean();
    result.low = result.value;
    result.high = result.value;
    if (const auto evidence = stats::mean_evidence(means, 0, {.unmet = {}, .rounding = 0})) {
        const stats::Interval interval = stats::interval_of(*evidence, level);
        result.low = interval.low;
        result.high = interval.high;
    }
    result.low -= rounding;
    result.high += rounding;
    return result;
}

}  // namespace

PlainReference plain_reference(const Scene& scene, std::size_t from, std::size_t to, const ReferenceEffort& effort,
                               StreamKey key) {
    if (area(scene.surfaces[to].shape) < area(scene.surfaces[from].shape)) std::swap(from, to);
    const Surface& source = scene.surfaces[from];
    const double source_area = area(source.shape);
    const test::PlainVisiblePolygon target(scene.surfaces[to], blockers_between(scene, source, scene.surfaces[to]));
    const SurfaceMap places(source);
    const auto points = samplers::find("sobol").make({.points = effort.most_points, .dimension = 2});
    const auto block = std::make_unique<WeightedBlock>();
    block->dimension = 2;
    std::vector<double> sums(effort.randomisations, 0.0);
    std::vector<double> means(effort.randomisations);
    // Enough points at first that all of them together miss little of what is seen.
    constexpr std::uint64_t fewest = 256;
    std::uint64_t done = 0;
    PlainReference result;
    for (std::uint64_t wanted = std::min(fewest, effort.most_points); wanted <= effort.most_points; wanted *= 2) {
        for (std::uint32_t r = 0; r < effort.randomisations; ++r) {
            const Stream stream{key, r, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to + 1)};
            for (PointIndex first = done; first < wanted; first += block->size) {
                block->size = std::min<std::uint64_t>(block_capacity, wanted - first);
                points->fill(stream, first, *block);
                for (std::size_t k = 0; k < block->size; ++k) {
                    const SurfacePoint place = places.at(block->coordinate[0][k], block->coordinate[1][k]);
                    sums[r] += target.from(place.position, source.normal).visible;
                }
            }
            means[r] = sums[r] * source_area / static_cast<double>(wanted);
        }
        done = wanted;
        constexpr double rounding = 1e-12;
        result = around(means, rounding * source_area, effort.level);
        if (std::max(result.high - result.value, result.value - result.low) <= effort.accuracy * source_area) break;
    }
    return result;
}

}  // namespace ff::studies::form_factors
