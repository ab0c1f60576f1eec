#include "core/estimators/pairs/area_kernel.hpp"

#include "core/estimators/graded_map.hpp"
#include "core/estimators/pairs/transfer.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/patches/patch_order.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <memory>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// A surface as the kernel sees it: for a parallelogram, one patch moved to the origin, and the corners of all patches.
struct PatchedSurface {
    const Surface* surface = nullptr;
    std::uint32_t first_patch = 0;  ///< index of its first patch among all patches of the scene
    Grid grid = undivided;
    SurfaceMap map;
    double patch_area = 0;
    Parallelogram shape;                   ///< first patch; the others have the same edges
    std::vector<Eigen::Vector3d> corners;  ///< corner of each patch

    [[nodiscard]] std::size_t patches() const { return grid.parts(); }

    /// The point at (s, t) on a patch.
    [[nodiscard]] SurfacePoint at(std::size_t patch, double s, double t) const {
        const std::size_t column = patch % grid.columns;
        const std::size_t row = patch / grid.columns;
        return map.at((static_cast<double>(column) + s) / grid.columns, (static_cast<double>(row) + t) / grid.rows);
    }
};

std::vector<PatchedSurface> divide(const Scene& scene, Subdivision subdivision) {
    const PatchOrder order(scene, subdivision);
    std::vector<PatchedSurface> result;
    for (const Surface& surface : scene.surfaces) {
        const Grid grid = subdivision.of(surface);
        PatchedSurface divided{
            &surface, order.first(result.size()), grid, SurfaceMap(surface), area(surface.shape) / grid.parts(), {},
            {}};
        if (const auto* shape = std::get_if<Parallelogram>(&surface.shape)) {
            divided.shape = patch(*shape, grid, 0);
            divided.patch_area = area(divided.shape);
            for (std::uint32_t p = 0; p < grid.parts(); ++p) divided.corners.push_back(patch(*shape, grid, p).corner);
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
    std::vector<double> of_source;         ///< the part of each source patch
    std::vector<double> of_target;         ///< the part of each target patch; for pairs that stand for both orders only
    std::vector<const Surface*> blockers;  ///< what may stand in between

    [[nodiscard]] Normals normals() const { return {from->surface->normal, to->surface->normal}; }

    /// Whether the vectorised sum will do: two parallelograms that nothing stands between.
    [[nodiscard]] bool is_plain() const { return blockers.empty() && !from->corners.empty() && !to->corners.empty(); }
};

/// Ordered pairs; with `Pairs::unordered`, each pair once.
enum class Pairs { ordered, unordered };

std::vector<SurfacePair> visible_pairs(const Scene& scene, const std::vector<PatchedSurface>& surfaces, Pairs pairs) {
    std::vector<SurfacePair> result;
    for (const PatchedSurface& from : surfaces) {
        for (const PatchedSurface& to : surfaces) {
            if (from.surface->face == no_face || to.surface->face == no_face) continue;
            if (pairs == Pairs::unordered && &to < &from) continue;
            if (!face_each_other(*from.surface, *to.surface)) continue;
            SurfacePair pair{&from, &to, 0, std::vector<double>(from.patches()), {}, {}};
            if (pairs == Pairs::unordered && &from != &to) pair.of_target.resize(to.patches());
            if (!scene.empty_box) pair.blockers = possible_blockers(scene, *from.surface, *to.surface);
            result.push_back(std::move(pair));
        }
    }
    return result;
}

Parallelogram patch_at(const PatchedSurface& divided, std::size_t patch) {
    return {divided.corners[patch], divided.shape.edge_u, divided.shape.edge_v};
}

/// The transfer of one pair of patches of any shape, point by point: pairs of points that blockers hide from each other
/// count as 0.
double transfer_in_sight(const SurfacePair& pair, std::size_t source, std::size_t target, const WeightedBlock& block) {
    double sum = 0;
    for (std::size_t i = 0; i < block.size; ++i) {
        const SurfacePoint from = pair.from->at(source, block.coordinate[0][i], block.coordinate[1][i]);
        const SurfacePoint to = pair.to->at(target, block.coordinate[2][i], block.coordinate[3][i]);
        const Eigen::Vector3d apart = to.position - from.position;
        const double leaving = apart.dot(from.normal);
        const double arriving = -apart.dot(to.normal);
        if (!(leaving > 0 && arriving > 0)) continue;
        if (!sees(from.position, *pair.from->surface, to.position, *pair.to->surface, pair.blockers)) continue;
        const double squared = apart.squaredNorm();
        sum += block.weight[i] * leaving * arriving / (squared * squared);
    }
    return sum;
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
    std::vector<GradedPair> pairs;                  ///< in the order of source patches, then of target patches
    std::vector<std::vector<std::size_t>> targets;  ///< targets of each source patch, ascending
};

GradedPatches find_graded(const SurfacePair& pair, PointMap map) {
    GradedPatches found;
    found.targets.resize(pair.from->patches());
    if (map == PointMap::uniform || !pair.is_plain()) return found;
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

/// The pairs of one source patch with all patches of a surface except some.
struct Offsets {
    std::vector<Eigen::Vector3d> offsets;
    std::vector<std::size_t> targets;
    std::vector<double> sums;  ///< one for each target; empty where they are not wanted

    void collect(const SurfacePair& pair, std::size_t source, const std::vector<std::size_t>& left_out) {
        offsets.clear();
        targets.clear();
        for (std::size_t j = 0; j < pair.to->corners.size(); ++j) {
            if (std::binary_search(left_out.begin(), left_out.end(), j)) continue;
            offsets.emplace_back(pair.to->corners[j] - pair.from->corners[source]);
            targets.push_back(j);
        }
        sums.assign(pair.of_target.empty() ? 0 : offsets.size(), 0.0);
    }
};

void add_to_source(SurfacePair& pair, std::size_t source, double transfer) {
    pair.transfer += transfer;
    pair.of_source[source] += transfer;
}

/// All pairs of patches of one pair of surfaces.
void sum_in_sight(const PointSource& points, const WeightedBlock& block, SurfacePair& pair) {
    for (std::size_t i = 0; i < pair.from->patches(); ++i) {
        points.checkpoint();
        for (std::size_t j = 0; j < pair.to->patches(); ++j) {
            const double transfer = transfer_in_sight(pair, i, j, block);
            add_to_source(pair, i, transfer);
            if (!pair.of_target.empty()) pair.of_target[j] += transfer;
        }
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
    Offsets all;
    for_each_block(points, stream, 0, points.points(), *block, [&](PointIndex) {
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            SurfacePair& pair = pairs[k];
            if (!pair.is_plain()) {
                sum_in_sight(points, *block, pair);
                continue;
            }
            separate(pair.from->shape, pair.to->shape, *block, *separations);
            for (std::size_t i = 0; i < pair.from->corners.size(); ++i) {
                points.checkpoint();
                all.collect(pair, i, graded[k].targets[i]);
                add_to_source(pair, i, sum_transfer(*separations, all.offsets, pair.normals(), all.sums));
                for (std::size_t n = 0; n < all.sums.size(); ++n) pair.of_target[all.targets[n]] += all.sums[n];
            }
            auto touching = graded[k].pairs.begin();
            for (std::size_t i = 0; i < graded[k].targets.size(); ++i) {
                for (const std::size_t j : graded[k].targets[i]) {
                    *graded_block = *block;
                    const double transfer = graded_transfer(*touching++, pair.normals(), *graded_block, *separations);
                    add_to_source(pair, i, transfer);
                    if (!pair.of_target.empty()) pair.of_target[j] += transfer;
                }
            }
        }
    });
}

/// Every ordered pair of patches has points of its own.
void sum_with_own_points(const PointSource& points, Stream stream, PointMap map, std::vector<SurfacePair>& pairs) {
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    const auto separations = std::make_unique_for_overwrite<Separations>();
    for (SurfacePair& pair : pairs) {
        for (std::uint32_t i = 0; i < pair.from->patches(); ++i) {
            stream.source = pair.from->first_patch + i;
            for (std::uint32_t j = 0; j < pair.to->patches(); ++j) {
                stream.target = pair.to->first_patch + j + 1;
                if (!pair.is_plain()) {
                    for_each_block(points, stream, 0, points.points(), *block,
                                   [&](PointIndex) { add_to_source(pair, i, transfer_in_sight(pair, i, j, *block)); });
                    continue;
                }
                const Eigen::Vector3d offset = pair.to->corners[j] - pair.from->corners[i];
                const auto graded =
                    map == PointMap::graded ? grade_pair(patch_at(*pair.from, i), patch_at(*pair.to, j)) : std::nullopt;
                for_each_block(points, stream, 0, points.points(), *block, [&](PointIndex) {
                    if (graded) {
                        add_to_source(pair, i, graded_transfer(*graded, pair.normals(), *block, *separations));
                    } else {
                        separate(pair.from->shape, pair.to->shape, *block, *separations);
                        add_to_source(pair, i, sum_transfer(*separations, {&offset, 1}, pair.normals()));
                    }
                });
            }
        }
    }
}

/// Factors of the patches of one surface to a face, from their parts of a transfer.
void add_factors(const PatchedSurface& surface, int face, const std::vector<double>& parts, double scale,
                 Eigen::MatrixXd& factors) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
        factors(static_cast<Eigen::Index>(surface.first_patch + p), face) += scale * parts[p];
    }
}

void add_patch_factors(const Scene& scene, Subdivision subdivision, const std::vector<SurfacePair>& pairs,
                       PatchFactorSums& sums) {
    const auto patches = static_cast<Eigen::Index>(subdivision.patches(scene));
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(patches, faces);
    for (const SurfacePair& pair : pairs) {
        const double to_target = pair.to->patch_area / std::numbers::pi;
        const double to_source = pair.from->patch_area / std::numbers::pi;
        add_factors(*pair.from, pair.to->surface->face, pair.of_source, to_target, factors);
        add_factors(*pair.to, pair.from->surface->face, pair.of_target, to_source, factors);
    }
    FF_EXPECT(sums.factors.empty() || sums.factors.size() == static_cast<std::size_t>(factors.size()));
    sums.factors.resize(static_cast<std::size_t>(factors.size()));
    sums.factors_squared.resize(sums.factors.size());
    std::size_t at = 0;
    for (const double factor : factors.reshaped<Eigen::RowMajor>()) {
        sums.factors[at] += factor;
        sums.factors_squared[at++] += factor * factor;
    }
}

}  // namespace

Eigen::MatrixXd area_kernel(const Scene& scene, Subdivision subdivision, const PointSource& points, PointMap map,
                            StreamKey key, std::uint32_t trial, PatchFactorSums* sums) {
    const std::vector<PatchedSurface> surfaces = divide(scene, subdivision);
    const bool common = !points.randomised();
    // Swapping the patches of a pair then only reorders the terms of a sum.
    const bool symmetric = common && points.exchangeable();
    std::vector<SurfacePair> pairs = visible_pairs(scene, surfaces, symmetric ? Pairs::unordered : Pairs::ordered);
    const Stream stream{.key = key, .trial = trial};
    if (common) {
        sum_with_common_points(points, stream, map, pairs);
    } else {
        sum_with_own_points(points, stream, map, pairs);
    }

    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::VectorXd areas(faces);
    for (Eigen::Index face = 0; face < faces; ++face) areas[face] = face_area(scene, static_cast<int>(face));
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    for (const SurfacePair& pair : pairs) {
        const int from = pair.from->surface->face;
        const int to = pair.to->surface->face;
        const double exchange = pair.transfer * pair.from->patch_area * pair.to->patch_area / std::numbers::pi;
        result(from, to) += exchange / areas[from];
        if (symmetric && pair.from != pair.to) result(to, from) += exchange / areas[to];
    }
    if (sums != nullptr) add_patch_factors(scene, subdivision, pairs, *sums);
    return result;
}

std::optional<Integrand> AreaKernel::integrand(const EstimatorOptions& options, PairClass pair_class, Hiding hiding) {
    if (pair_class == PairClass::adjacent) {
        return options.map == PointMap::graded && hiding == Hiding::none ? Integrand::rough : Integrand::unbounded;
    }
    return hiding == Hiding::possible ? Integrand::jumping : Integrand::smooth;
}

void AreaKernel::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const {
    outcome.estimates =
        area_kernel(scene(), task.subdivision, *task.points, task.options.map, task.key, task.trial, &totals.factors);
}

}  // namespace ff
