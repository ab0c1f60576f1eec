#pragma once

#include "core/estimators/estimator.hpp"
#include "core/estimators/unmet.hpp"
#include "core/visibility/visible_polygon.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff {

/// `point_to_polygon` with shadows cut out: the method `points` of `ffstudy form-factors`.
class PointToVisiblePolygon {
  public:
    static constexpr EstimatorInfo info{
        .name = "visible_polygon",
        .summary = "exact factors from points of the source to what they see of each face (shadows cut out)",
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
    static double nanoseconds(const EstimatorOptions& options, const Scene& scene);
    static std::optional<Integrand> integrand(const EstimatorOptions& options, PairClass pair_class, Hiding hiding);
    static constexpr auto largest_unmet = &largest_unmet_factor;

    PointToVisiblePolygon(const Scene& scene, TracerChoice tracer);
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    struct Target {
        std::uint32_t surface = 0;
        VisiblePolygon polygon;
    };
    const Scene* scene_;
    std::vector<std::vector<Target>> targets_;  ///< targets of each surface that sees some
};

}  // namespace ff
