#pragma once

#include "core/estimators/entry.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace ff {

/// A parallelogram or a triangle, made ready for many lines.
struct FlatPiece {
    Eigen::Vector3d corner;
    Eigen::Vector3d normal;
    Eigen::Vector3d along_u;  ///< its product with a place relative to the corner: the share of the edge u
    Eigen::Vector3d along_v;
    bool is_triangle = false;
    int face = 0;
};

/// A side of the box around all faces.
struct BoxSide {
    int axis = 0;  ///< across it
    bool high = false;
    double area = 0;
};

/// Lines through the whole scene, each an exchange between all neighbours on it.
class GlobalLines : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "global_lines",
        .summary = "uniform lines through the whole scene; one set serves all faces (Sbert)",
        .details =
            "A 4-D point gives a line through the box around the scene, uniform as integral geometry measures lines: a "
            "place\non the box (2) and from there a cosine-distributed direction (2). Wherever it leaves the front of "
            "one surface and arrives\nnext at the front of another, a ray went from each to the other. The estimate of "
            "F(i, j) is the share of the\ncrossings of face i from which the next surface is face j, so that the rows "
            "of a closed scene add up to 1. Unbiased\nwith random points, as long as every face is crossed; small "
            "faces get few lines. Works with every shape and\noccluder; the time for a line grows with the number of "
            "surfaces. samples_per_patch counts lines, of the whole scene;\nfaces are not divided.",
        .reference = "sbert1993",
        .dimension = 4,
        .points = PointsServe::scene,
        .whole_faces = true,
        .sees_occluders = true,
        .evaluations = "lines",
        .integrands = {.apart = Integrand::jumping, .adjacent = Integrand::jumping},
    };

    static double nanoseconds(const EstimatorOptions& /*options*/, const Scene& scene) {
        return 60.0 + 8.0 * static_cast<double>(scene.surfaces.size());
    }
    /// A line's crossings count by the expected number of all: twice the face's area over that of the box for each
    /// line.
    static double largest_unmet(const Scene& scene, int from, int to, double evaluations);

    GlobalLines(const Scene& scene, TracerChoice tracer);
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    std::vector<FlatPiece> flat_;
    std::vector<const Surface*> round_;  ///< discs too
    Eigen::AlignedBox3d box_;            ///< box around all faces
    std::vector<BoxSide> sides_;         ///< those that have an area
    double area_ = 0;                    ///< total area of the sides, in squared units of length
};

}  // namespace ff
