#include "core/radiosity/patch_factors.hpp"

#include "core/area_kernel.hpp"
#include "core/contract.hpp"
#include "core/exact.hpp"
#include "core/facing.hpp"
#include "core/patch_exchange.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace ff {
namespace {

/// The patch of a surface's grid that a hit lies in.
std::uint32_t patch_of(const Hit& hit, Subdivision subdivision) {
    const auto cell = [&](float coordinate) {
        const float scaled = coordinate * static_cast<float>(subdivision.m);
        return std::min(static_cast<std::uint32_t>(std::max(scaled, 0.0f)), subdivision.m - 1);
    };
    return hit.surface * subdivision.per_surface() + cell(hit.t) * subdivision.m + cell(hit.s);
}

/// Every patch as a surface of its own.
std::vector<Surface> patches_of(const Scene& scene, Subdivision subdivision) {
    std::vector<Surface> all;
    for (const Surface& surface : scene.surfaces) {
        for (std::uint32_t p = 0; p < subdivision.per_surface(); ++p) {
            all.push_back(surface);
            all.back().shape = patch(parallelogram(surface), subdivision, p);
        }
    }
    return all;
}

}  // namespace

Eigen::MatrixXd shoot_patch_factors(const Scene& scene, Subdivision subdivision, const Tracer& tracer,
                                    const PointSource& points, std::uint64_t samples_per_patch, Allocation allocation,
                                    StreamKey key, std::uint32_t trial) {
    FF_EXPECT(points.equal_weights());
    const std::uint32_t per_surface = subdivision.per_surface();
    const Eigen::Index patches = subdivision.patches(scene);
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(patches, patches);
    const auto block = std::make_unique<PointBlock>();
    RayBatch rays;
    std::vector<Hit> hits;
    for (std::uint32_t surface = 0; surface < scene.surfaces.size(); ++surface) {
        for (std::uint32_t p = 0; p < per_surface; ++p) {
            const std::uint32_t patch = surface * per_surface + p;
            const bool own_stream = allocation == Allocation::patch;
            const Stream stream{.key = key, .trial = trial, .source = own_stream ? patch : surface};
            const PointIndex first = own_stream ? 0 : p * samples_per_patch;
            for (std::uint64_t done = 0; done < samples_per_patch; done += block->size) {
                block->size =
                    static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, samples_per_patch - done));
                points.fill(stream, first + done, *block);
                generate_rays(scene.surfaces[surface], surface, subdivision, p, *block, rays);
                hits.resize(rays.size());
                tracer.trace(rays, hits);
                for (const Hit& hit : hits) {
                    if (hit.surface != no_surface && hit.received) factors(patch, patch_of(hit, subdivision)) += 1;
                }
            }
        }
    }
    return factors / static_cast<double>(samples_per_patch);
}

Eigen::MatrixXd kernel_patch_factors(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                     PointMap map, StreamKey key, std::uint32_t trial) {
    // Streams are keyed by patches, whose numbers stay what they are when each is a face of its own.
    Scene divided;
    divided.surfaces = patches_of(scene, subdivision);
    divided.faces.resize(divided.surfaces.size());
    divided.empty_box = scene.empty_box;
    for (std::size_t i = 0; i < divided.surfaces.size(); ++i) divided.surfaces[i].face = static_cast<int>(i);
    return area_kernel(divided, Subdivision{1}, points, map, key, trial);
}

std::optional<Eigen::MatrixXd> exact_patch_factors(const Scene& scene, Subdivision subdivision) {
    const Eigen::Index patches = subdivision.patches(scene);
    const Eigen::Index per_surface = subdivision.per_surface();
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(patches, patches);
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Surface& from = scene.surfaces[i];
            const Surface& to = scene.surfaces[j];
            if (!exact_exchange_area(from, to)) return std::nullopt;
            const Eigen::MatrixXd areas = patch_exchange(from, to, subdivision).areas;
            const auto row = static_cast<Eigen::Index>(i) * per_surface;
            const auto column = static_cast<Eigen::Index>(j) * per_surface;
            const auto patch_area = [&](const Surface& surface) {
                return area(surface.shape) / static_cast<double>(per_surface);
            };
            factors.block(row, column, per_surface, per_surface) = areas / patch_area(from);
            factors.block(column, row, per_surface, per_surface) = areas.transpose() / patch_area(to);
        }
    }
    return factors;
}

Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision) {
    Eigen::VectorXd areas(subdivision.patches(scene));
    for (std::size_t surface = 0; surface < scene.surfaces.size(); ++surface) {
        areas.segment(static_cast<Eigen::Index>(surface) * subdivision.per_surface(), subdivision.per_surface())
            .setConstant(area(scene.surfaces[surface].shape) / subdivision.per_surface());
    }
    return areas;
}

Sight patch_sight(const Scene& scene, Subdivision subdivision) {
    const std::vector<Surface> all = patches_of(scene, subdivision);
    const Eigen::Index patches = subdivision.patches(scene);
    Sight sight = Sight::Constant(patches, patches, false);
    for (Eigen::Index i = 0; i < patches; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            // Patches of one surface are in one plane, but for rounding.
            const bool seen = i / subdivision.per_surface() != j / subdivision.per_surface() &&
                              face_each_other(all[static_cast<std::size_t>(i)], all[static_cast<std::size_t>(j)]);
            sight(i, j) = seen;
            sight(j, i) = seen;
        }
    }
    return sight;
}

}  // namespace ff
