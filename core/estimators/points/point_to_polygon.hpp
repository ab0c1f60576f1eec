#pragma once

#include "core/estimators/entry.hpp"
#include "core/estimators/unmet.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/visible_polygon.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ff {

/// One trial of the point-to-polygon estimator: at every 2-D point of `points` on a source patch, the exact form factor
/// from the differential area there to each visible surface (core/formulas/polygon_factor), averaged over points and
/// patches and summed into faces. One set of points serves all targets. The only error left is that of the two
/// integrals over the source.
///
/// Unbiased with random points; the integrand lies in [0, 1] and is smooth, except at corners that two faces
/// share. Streams are keyed as in `ray_shooting`: by source patch, or by part of a grid with Allocation::face.
/// Weights of `points` count with Allocation::patch; with Allocation::face all must be equal. The same bits on
/// every CPU.
/// @param samples_per_patch points.points() with Allocation::patch; the number per patch with Allocation::face
/// @return face-to-face matrix, every entry estimated directly; the diagonal is 0 where a face does not see itself
/// @pre all surfaces are parallelograms, and nothing stands between two of them: core/visibility/occlusion.hpp
Eigen::MatrixXd point_to_polygon(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                 std::uint64_t samples_per_patch, Allocation allocation, StreamKey key,
                                 std::uint32_t trial);

/// The same as an estimator.
class PointToPolygon : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "point_to_polygon",
        .summary = "exact factors from points of the source to each face (Lambert's formula)",
        .details =
            "A 2-D point lies on the source patch; from there the form factor to every visible face is exact: a sum "
            "over the edges\nof the face, each the angle under which it is seen times a cosine. Points are shared by "
            "all targets, and subdivision\ndivides the source only. Unbiased with random points, of values between 0 "
            "and 1; smooth between parallel faces, with a\njump at the corners where three faces meet. Works with "
            "every sampler in two dimensions (so stratified takes k^2 points)\nand, deterministically, with "
            "Gauss-Legendre nodes. Unoccluded convex scenes only.",
        .reference = "baum1989",
        .dimension = 2,
        .points = PointsServe::patches,
        .largest_value = 1,
        .nanoseconds = 60,  // for all faces of a box
        .integrands = {.apart = Integrand::smooth, .adjacent = Integrand::rough},
    };

    /// All surfaces have to be parallelograms.
    static std::string refusal(const EstimatorOptions& options, const Scene& scene);
    static constexpr auto largest_unmet = &largest_unmet_factor;

    using SceneEstimator::SceneEstimator;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;
};

/// `point_to_polygon` with occluded parts cut out: the method `points` of `ffstudy form-factors`.
class PointToVisiblePolygon : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "visible_polygon",
        .summary = "exact factors from points of the source to what they see of each face (occluded parts cut out)",
        .details =
            "A 2-D point lies on the source patch; from there the shadow of everything that stands in the way is cut "
            "out of\neach face, and Lambert's formula gives the factor to what is left, exactly. Points are shared by "
            "all targets.\nUnbiased with random points, of values between 0 and 1, continuous but for kinks where "
            "shadows begin. What\nstands in the way of nothing costs nothing; for scenes without occluders "
            "point_to_polygon is the faster one.\nFaces and what may hide them have to be parallelograms and "
            "triangles. It is the method `points` of\n`ffstudy form-factors`, which chooses sizes by itself.",
        .reference = "baum1989",
        .dimension = 2,
        .points = PointsServe::patches,
        .sees_occluders = true,
        .largest_value = 1,
    };

    static std::string refusal(const EstimatorOptions& options, const Scene& scene);
    static double nanoseconds(const EstimatorOptions& /*options*/, const Scene& scene) {
        return 200.0 * static_cast<double>(scene.faces.size());
    }
    static std::optional<Integrand> integrand(const EstimatorOptions& /*options*/, PairClass pair_class,
                                              Hiding hiding) {
        const bool kinks = pair_class == PairClass::adjacent || hiding == Hiding::possible;
        return kinks ? Integrand::rough : Integrand::smooth;
    }
    static constexpr auto largest_unmet = &largest_unmet_factor;

    PointToVisiblePolygon(const Scene& scene, TracerChoice tracer);
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    struct Target {
        std::uint32_t surface = 0;
        VisiblePolygon polygon;
    };
    std::vector<std::vector<Target>> targets_;  ///< targets of each surface that sees some
};

/// A patch that points are laid on.
struct SourcePatch {
    std::uint32_t surface = 0;  ///< index into Scene::surfaces
    Grid grid = undivided;
    std::uint32_t index = 0;  ///< position in the grid
};

/// Adds to `sums`, by surface of the scene, the sum over the points of a block of weight * (the form factor from the
/// point to that surface).
using SourceSum = std::function<void(const SourcePatch& patch, const WeightedBlock& block, std::span<double> sums)>;

/// One trial of an estimator whose points serve a patch of the source and all that it sees: face-to-face factors, every
/// entry estimated directly. Streams are keyed as in `ray_shooting`: by source patch, or by part of a grid with
/// Allocation::face. Sums run in a fixed order.
/// @pre weights are equal with Allocation::face
Eigen::MatrixXd average_over_sources(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                     const SourceSum& sum);

}  // namespace ff
