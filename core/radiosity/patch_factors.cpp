#include "core/radiosity/patch_factors.hpp"

#include "core/area_kernel.hpp"
#include "core/contract.hpp"
#include "core/facing.hpp"
#include "core/mirrors.hpp"
#include "core/occlusion.hpp"
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
    return cell(hit.t) * subdivision.m + cell(hit.s);
}

/// The first row or column of each surface's patches: those without a face have none.
std::vector<Eigen::Index> first_patches(const Scene& scene, Subdivision subdivision) {
    std::vector<Eigen::Index> first;
    Eigen::Index next = 0;
    for (const Surface& surface : scene.surfaces) {
        first.push_back(next);
        if (is_of_face(surface)) next += subdivision.per_surface();
    }
    return first;
}

/// Every patch as a surface of its own, those of surfaces without a face too.
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
    const auto patches = static_cast<Eigen::Index>(radiating_patches(scene, subdivision));
    const std::vector<Eigen::Index> rows = first_patches(scene, subdivision);
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(patches, patches);
    const auto block = std::make_unique<PointBlock>();
    RayBatch rays;
    std::vector<Hit> hits;
    for (std::uint32_t surface = 0; surface < scene.surfaces.size(); ++surface) {
        if (!is_of_face(scene.surfaces[surface])) continue;
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
                    if (hit.surface == no_surface || !hit.received) continue;
                    factors(rows[surface] + p, rows[hit.surface] + patch_of(hit, subdivision)) += 1;
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
    divided.faces.resize(radiating_patches(scene, subdivision));
    // Nothing between surfaces is nothing between their patches: looking again takes the cube of their number.
    if (!may_be_occluded(scene)) divided.empty_box = scene.empty_box.value_or(Eigen::Vector3d::Zero());
    int face = 0;
    for (Surface& surface : divided.surfaces) {
        if (is_of_face(surface)) surface.face = face++;
    }
    return area_kernel(divided, Subdivision{1}, points, map, key, trial);
}

std::optional<Eigen::MatrixXd> exact_patch_factors(const Scene& scene, Subdivision subdivision) {
    const auto patches = static_cast<Eigen::Index>(radiating_patches(scene, subdivision));
    const std::vector<Eigen::Index> rows = first_patches(scene, subdivision);
    const Eigen::Index per_surface = subdivision.per_surface();
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(patches, patches);
    if (!has_exact_patch_factors(scene)) return std::nullopt;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Surface& from = scene.surfaces[i];
            const Surface& to = scene.surfaces[j];
            if (!is_of_face(from) || !is_of_face(to)) continue;
            Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(per_surface, per_surface);
            const auto places = images(scene, to);
            for (const Surface& place : *places) {
                if (face_each_other(from, place)) areas += patch_exchange(from, place, subdivision).areas;
            }
            const auto patch_area = [&](const Surface& surface) {
                return area(surface.shape) / static_cast<double>(per_surface);
            };
            factors.block(rows[i], rows[j], per_surface, per_surface) = areas / patch_area(from);
            factors.block(rows[j], rows[i], per_surface, per_surface) = areas.transpose() / patch_area(to);
        }
    }
    return factors;
}

bool has_exact_patch_factors(const Scene& scene) {
    return has_only_parallelograms(scene) && !may_be_occluded(scene) && images(scene, scene.surfaces.front());
}

std::uint32_t radiating_patches(const Scene& scene, Subdivision subdivision) {
    const auto surfaces = std::count_if(scene.surfaces.begin(), scene.surfaces.end(),
                                        [](const Surface& surface) { return is_of_face(surface); });
    return subdivision.per_surface() * static_cast<std::uint32_t>(surfaces);
}

Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision) {
    Eigen::VectorXd areas(static_cast<Eigen::Index>(radiating_patches(scene, subdivision)));
    Eigen::Index next = 0;
    for (const Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) continue;
        areas.segment(next, subdivision.per_surface()).setConstant(area(surface.shape) / subdivision.per_surface());
        next += subdivision.per_surface();
    }
    return areas;
}

Sight patch_sight(const Scene& scene, Subdivision subdivision) {
    std::vector<Surface> all = patches_of(scene, subdivision);
    all.erase(std::remove_if(all.begin(), all.end(), [](const Surface& patch) { return !is_of_face(patch); }),
              all.end());
    std::vector<std::vector<Surface>> places;  // itself and its images
    for (const Surface& patch : all) places.push_back(images(scene, patch).value_or(std::vector{patch}));
    const auto patches = static_cast<Eigen::Index>(all.size());
    const auto per_surface = static_cast<Eigen::Index>(subdivision.per_surface());
    Sight sight = Sight::Constant(patches, patches, false);
    for (Eigen::Index i = 0; i < patches; ++i) {
        const Surface& from = all[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j <= i; ++j) {
            const std::vector<Surface>& seen = places[static_cast<std::size_t>(j)];
            // Patches of one surface are in one plane, but for rounding.
            const bool same_plane = i / per_surface == j / per_surface;
            sight(i, j) = std::any_of(seen.begin() + (same_plane ? 1 : 0), seen.end(),
                                      [&](const Surface& place) { return face_each_other(from, place); });
            sight(j, i) = sight(i, j);
        }
    }
    return sight;
}

}  // namespace ff
