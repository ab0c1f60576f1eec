#include "core/radiosity/patch_factors.hpp"

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/placement.hpp"
#include "core/patches/patch_order.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace ff {
namespace {

/// The patch of a surface's grid that a hit lies in.
std::uint32_t patch_of(const Hit& hit, Grid grid) {
    const auto cell = [](float coordinate, std::uint32_t cells) {
        const float scaled = coordinate * static_cast<float>(cells);
        return std::min(static_cast<std::uint32_t>(std::max(scaled, 0.0f)), cells - 1);
    };
    return cell(hit.t, grid.rows) * grid.columns + cell(hit.s, grid.columns);
}

/// Every patch as a surface of its own, those of surfaces without a face too.
std::vector<Surface> patches_of(const Scene& scene, Subdivision subdivision) {
    std::vector<Surface> all;
    for (const Surface& surface : scene.surfaces) {
        const Grid grid = subdivision.of(surface);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) all.push_back(patch(surface, grid, p));
    }
    return all;
}

}  // namespace

Eigen::MatrixXd shoot_patch_factors(const Scene& scene, Subdivision subdivision, const Tracer& tracer,
                                    const PointSource& points, std::uint64_t samples_per_patch, Allocation allocation,
                                    StreamKey key, std::uint32_t trial) {
    FF_EXPECT(points.equal_weights());
    const PatchOrder rows(scene, subdivision, Numbered::of_faces);
    const PatchSequences sequences(scene, subdivision, allocation, samples_per_patch);
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(rows.size(), rows.size());
    const auto block = std::make_unique<PointBlock>();
    const Scene where = placed(scene);
    std::vector<Hit> hits;
    for (std::uint32_t surface = 0; surface < scene.surfaces.size(); ++surface) {
        if (!is_of_face(scene.surfaces[surface])) continue;
        const Grid grid = subdivision.of(scene.surfaces[surface]);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            const auto [source, first] = sequences.of(surface, p);
            const Stream stream{.key = key, .trial = trial, .source = source};
            for_each_block(points, stream, first, samples_per_patch, *block, [&](PointIndex) {
                hits.resize(block->size);
                tracer.find_ends(where.surfaces[surface], surface, grid, p, *block, hits);
                for (const Hit& hit : hits) {
                    if (hit.surface == no_surface || !hit.received) continue;
                    const Grid of_target = subdivision.of(scene.surfaces[hit.surface]);
                    factors(rows.first(surface) + p, rows.first(hit.surface) + patch_of(hit, of_target)) += 1;
                }
            });
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
    if (!has_exact_patch_factors(scene)) return std::nullopt;
    const PatchOrder rows(scene, subdivision, Numbered::of_faces);
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(rows.size(), rows.size());
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Surface& from = scene.surfaces[i];
            const Surface& to = scene.surfaces[j];
            if (!is_of_face(from) || !is_of_face(to)) continue;
            Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(rows.count(i), rows.count(j));
            const auto places = images(scene, to);
            for (const Surface& place : *places) {
                if (face_each_other(from, place)) areas += patch_exchange(from, place, subdivision).areas;
            }
            const double from_area = area(from.shape) / rows.count(i);
            const double to_area = area(to.shape) / rows.count(j);
            factors.block(rows.first(i), rows.first(j), rows.count(i), rows.count(j)) = areas / from_area;
            factors.block(rows.first(j), rows.first(i), rows.count(j), rows.count(i)) = areas.transpose() / to_area;
        }
    }
    return factors;
}

bool has_exact_patch_factors(const Scene& scene) {
    return has_only_parallelograms(scene) && !may_be_occluded(scene) && images(scene, scene.surfaces.front());
}

std::uint32_t radiating_patches(const Scene& scene, Subdivision subdivision) {
    return PatchOrder(scene, subdivision, Numbered::of_faces).size();
}

Eigen::VectorXd face_areas(const Scene& scene) {
    Eigen::VectorXd areas(static_cast<Eigen::Index>(scene.faces.size()));
    for (Eigen::Index i = 0; i < areas.size(); ++i) areas[i] = face_area(scene, static_cast<int>(i));
    return areas;
}

Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision) {
    const PatchOrder order(scene, subdivision, Numbered::of_faces);
    Eigen::VectorXd areas(order.size());
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const double patches = std::max(order.count(i), 1u);  // surfaces without a face have no numbered patches
        areas.segment(order.first(i), order.count(i)).setConstant(area(scene.surfaces[i].shape) / patches);
    }
    return areas;
}

Sight patch_sight(const Scene& scene, Subdivision subdivision) {
    std::vector<Surface> all = patches_of(scene, subdivision);
    std::erase_if(all, [](const Surface& patch) { return !is_of_face(patch); });
    std::vector<std::vector<Surface>> places;  // itself and its images
    for (const Surface& patch : all) places.push_back(images(scene, patch).value_or(std::vector{patch}));
    const auto patches = static_cast<Eigen::Index>(all.size());
    const PatchOrder order(scene, subdivision, Numbered::of_faces);
    std::vector<std::uint32_t> surface_of;
    for (std::uint32_t patch = 0; patch < order.size(); ++patch) surface_of.push_back(order.place(patch).surface);
    Sight sight = Sight::Constant(patches, patches, false);
    for (Eigen::Index i = 0; i < patches; ++i) {
        const Surface& from = all[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j <= i; ++j) {
            const std::vector<Surface>& seen = places[static_cast<std::size_t>(j)];
            // Patches of one surface are in one plane, but for rounding.
            const bool same_plane = surface_of[static_cast<std::size_t>(i)] == surface_of[static_cast<std::size_t>(j)];
            sight(i, j) = std::any_of(seen.begin() + (same_plane ? 1 : 0), seen.end(),
                                      [&](const Surface& place) { return face_each_other(from, place); });
            sight(j, i) = sight(i, j);
        }
    }
    return sight;
}

}  // namespace ff
