#include "core/area_kernel.hpp"

#include "core/facing.hpp"
#include "core/transfer.hpp"

#include <algorithm>
#include <memory>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// A surface as the kernel sees it: any of its patches moved to the origin, and the corners of all.
struct PatchedSurface {
    const Surface* surface = nullptr;
    std::uint32_t first_patch = 0;  ///< of the scene
    Parallelogram shape;            ///< of one patch
    std::vector<Eigen::Vector3d> corners;
};

std::vector<PatchedSurface> divide(const Scene& scene, Subdivision subdivision) {
    std::vector<PatchedSurface> result;
    for (const Surface& surface : scene.surfaces) {
        PatchedSurface divided{&surface,
                               static_cast<std::uint32_t>(result.size()) * subdivision.per_surface(),
                               patch(surface.shape, subdivision, 0),
                               {}};
        for (std::uint32_t p = 0; p < subdivision.per_surface(); ++p) {
            divided.corners.push_back(patch(surface.shape, subdivision, p).corner);
        }
        result.push_back(std::move(divided));
    }
    return result;
}

/// Two surfaces that exchange radiation, and what has been summed for them: sum_transfer over all pairs of patches.
struct SurfacePair {
    const PatchedSurface* from = nullptr;
    const PatchedSurface* to = nullptr;
    double transfer = 0;

    [[nodiscard]] Normals normals() const { return {from->surface->normal, to->surface->normal}; }
};

/// Ordered pairs; with `Pairs::unordered`, each pair once.
enum class Pairs { ordered, unordered };

std::vector<SurfacePair> visible_pairs(const std::vector<PatchedSurface>& surfaces, Pairs pairs) {
    std::vector<SurfacePair> result;
    for (const PatchedSurface& from : surfaces) {
        for (const PatchedSurface& to : surfaces) {
            if (from.surface->face == to.surface->face) continue;
            if (pairs == Pairs::unordered && &to < &from) continue;
            if (!face_each_other(*from.surface, *to.surface)) continue;
            result.push_back({&from, &to});
        }
    }
    return result;
}

/// Blocks of the whole point set of one stream.
template <class Visit>
void for_each_block(const PointSource& points, const Stream& stream, WeightedBlock& block, Visit visit) {
    const std::uint64_t count = points.points();
    for (std::uint64_t first = 0; first < count; first += block.size) {
        block.size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, count - first));
        points.fill(stream, first, block);
        visit();
    }
}

Parallelogram patch_at(const PatchedSurface& divided, std::size_t patch) {
    return {divided.corners[patch], divided.shape.edge_u, divided.shape.edge_v};
}

/// The transfer of one pair of patches whose points are graded. `block` is changed.
double graded_transfer(const GradedPair& pair, const Normals& normals, WeightedBlock& block, Separations& separations) {
    grade_points(pair.power, block);
    separate(pair.from, pair.to, block, separations);
    const Eigen::Vector3d offset = pair.to.corner - pair.from.corner;
    return sum_transfer(separations, {&offset, 1}, normals);
}

/// The pairs of patches of two surfaces that are graded.
struct GradedPatches {
    std::vector<GradedPair> pairs;
    std::vector<std::vector<std::size_t>> targets;  ///< by source patch, ascending
};

GradedPatches find_graded(const SurfacePair& pair, PointMap map) {
    GradedPatches found;
    found.targets.resize(pair.from->corners.size());
    if (map == PointMap::uniform) return found;
    for (std::size_t i = 0; i < pair.from->corners.size(); ++i) {
        for (std::size_t j = 0; j < pair.to->corners.size(); ++j) {
            const auto graded = grade_pair(patch_at(*pair.from, i), patch_at(*pair.to, j));
            if (!graded) continue;
            found.pairs.push_back(*graded);
            found.targets[i].push_back(j);
        }
    }
    return found;
}

/// Offsets from one patch to all patches of a surface but those left out.
void offsets_from(const Eigen::Vector3d& corner, const std::vector<Eigen::Vector3d>& targets,
                  const std::vector<std::size_t>& left_out, std::vector<Eigen::Vector3d>& offsets) {
    offsets.clear();
    for (std::size_t j = 0; j < targets.size(); ++j) {
        if (!std::binary_search(left_out.begin(), left_out.end(), j)) offsets.emplace_back(targets[j] - corner);
    }
}

/// One set of points serves all pairs of patches.
void sum_with_common_points(const PointSource& points, const Stream& stream, PointMap map,
                            std::vector<SurfacePair>& pairs) {
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    const auto graded_block = std::make_unique_for_overwrite<WeightedBlock>();
    const auto separations = std::make_unique_for_overwrite<Separations>();
    std::vector<GradedPatches> graded;
    for (const SurfacePair& pair : pairs) graded.push_back(find_graded(pair, map));
    std::vector<Eigen::Vector3d> offsets;
    for_each_block(points, stream, *block, [&] {
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            SurfacePair& pair = pairs[k];
            separate(pair.from->shape, pair.to->shape, *block, *separations);
            for (std::size_t i = 0; i < pair.from->corners.size(); ++i) {
                points.checkpoint();
                offsets_from(pair.from->corners[i], pair.to->corners, graded[k].targets[i], offsets);
                pair.transfer += sum_transfer(*separations, offsets, pair.normals());
            }
            for (const GradedPair& touching : graded[k].pairs) {
                *graded_block = *block;
                pair.transfer += graded_transfer(touching, pair.normals(), *graded_block, *separations);
            }
        }
    });
}

/// Every ordered pair of patches has points of its own.
void sum_with_own_points(const PointSource& points, Stream stream, PointMap map, std::vector<SurfacePair>& pairs) {
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    const auto separations = std::make_unique_for_overwrite<Separations>();
    for (SurfacePair& pair : pairs) {
        for (std::uint32_t i = 0; i < pair.from->corners.size(); ++i) {
            stream.source = pair.from->first_patch + i;
            for (std::uint32_t j = 0; j < pair.to->corners.size(); ++j) {
                stream.target = pair.to->first_patch + j + 1;
                const Eigen::Vector3d offset = pair.to->corners[j] - pair.from->corners[i];
                const auto graded =
                    map == PointMap::graded ? grade_pair(patch_at(*pair.from, i), patch_at(*pair.to, j)) : std::nullopt;
                for_each_block(points, stream, *block, [&] {
                    if (graded) {
                        pair.transfer += graded_transfer(*graded, pair.normals(), *block, *separations);
                    } else {
                        separate(pair.from->shape, pair.to->shape, *block, *separations);
                        pair.transfer += sum_transfer(*separations, {&offset, 1}, pair.normals());
                    }
                });
            }
        }
    }
}

}  // namespace

Eigen::MatrixXd area_kernel(const Scene& scene, Subdivision subdivision, const PointSource& points, PointMap map,
                            StreamKey key, std::uint32_t trial) {
    const std::vector<PatchedSurface> surfaces = divide(scene, subdivision);
    const bool common = !points.randomised();
    // Swapping the patches of a pair then only reorders the terms of a sum.
    const bool symmetric = common && points.exchangeable();
    std::vector<SurfacePair> pairs = visible_pairs(surfaces, symmetric ? Pairs::unordered : Pairs::ordered);
    const Stream stream{.key = key, .trial = trial};
    if (common) {
        sum_with_common_points(points, stream, map, pairs);
    } else {
        sum_with_own_points(points, stream, map, pairs);
    }

    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    for (const SurfacePair& pair : pairs) {
        const int from = pair.from->surface->face;
        const int to = pair.to->surface->face;
        const double exchange = pair.transfer * area(pair.from->shape) * area(pair.to->shape) / std::numbers::pi;
        result(from, to) += exchange / face_area(scene, from);
        if (symmetric) result(to, from) += exchange / face_area(scene, to);
    }
    return result;
}

}  // namespace ff
