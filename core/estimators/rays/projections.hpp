#pragma once

#include "core/estimators/rays/ray_shooting.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// Directions through the centres of the pixels of a projection, as seen from a patch, and the form factor that each
/// pixel stands for. Axes: x along the patch's first edge, z along its normal.
class PixelDirections {
  public:
    explicit PixelDirections(std::uint64_t expected) {
        for (auto* angles : {&squared_sine_, &azimuth_}) angles->reserve(expected);
        factor_.reserve(expected);
    }

    /// @param direction  of any length, z > 0
    void add(const Eigen::Vector3d& direction, double factor);

    [[nodiscard]] std::size_t size() const { return factor_.size(); }
    [[nodiscard]] double factor(std::size_t pixel) const { return factor_[pixel]; }

    /// The 4-D points (core/tracing/tracer.hpp) of consecutive pixels from `first`, from the middle of the patch;
    /// block.size of them, set by the caller.
    void fill(std::size_t first, PointBlock& block) const;

  private:
    std::vector<std::uint32_t> squared_sine_;
    std::vector<std::uint32_t> azimuth_;
    std::vector<double> factor_;
};

/// The base of all projections: rays through the pixels from the middle of every patch.
class PixelProjection : public SceneEstimator {
  public:
    PixelProjection(const Scene& scene, TracerChoice tracer);

    /// Form factors between faces: for each patch, the sum over the pixels that show the other face.
    [[nodiscard]] Eigen::MatrixXd factors(Subdivision subdivision, const PixelDirections& pixels) const;

    static constexpr auto refusal = &RayShooting::refusal;
    static double nanoseconds(const EstimatorOptions& options, const Scene& scene) {
        return 10.0 + RayShooting::nanoseconds(options, scene);
    }

  protected:
    /// "(a hemicube has 3 r^2 pixels, r even). Try 768 or 1200."
    static std::string no_such_size(std::string_view rule, std::uint64_t below, std::uint64_t above);

  private:
    Scene placed_;
    std::unique_ptr<const Tracer> tracer_;
};

/// Declarations that all projections share, besides their own ones.
constexpr EstimatorInfo projection(EstimatorInfo info) {
    info.own_points = true;
    info.has_tracer = true;
    info.sees_occluders = true;
    info.sees_reflections = true;
    info.needs_polygons = true;
    info.evaluations = "pixels";
    return info;
}

/// The finest of a projection's resolutions with at most `samples` pixels, from 0.
/// @param count  pixels of a resolution below 2^30: 0 at 0, increasing
std::uint64_t finest_resolution(std::uint64_t (*count)(std::uint64_t), std::uint64_t samples);

/// An estimator by a projection, which defines what is specific to it:
///
///     static constexpr EstimatorInfo info = projection({...});
///     static constexpr std::string_view sizes = "a hemicube has 3 r^2 pixels, r even";
///     static std::uint64_t count(std::uint64_t resolution);       // pixels; 0 at 0
///     static PixelDirections lay(std::uint64_t resolution);
template <class Projection>
class ByPixels : public PixelProjection {
  public:
    using PixelProjection::PixelProjection;

    static std::string size_problem(std::uint64_t samples) {
        const std::uint64_t finest = finest_resolution(&Projection::count, samples);
        const std::uint64_t below = Projection::count(finest);
        if (finest > 0 && below == samples) return {};
        return no_such_size(Projection::sizes, below, Projection::count(finest + 1));
    }
    /// @pre size_problem() is empty
    static PixelDirections pixels(std::uint64_t samples) {
        return Projection::lay(finest_resolution(&Projection::count, samples));
    }
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
        outcome.estimates = factors(task.subdivision, pixels(task.samples));
    }
};

/// The hemicube over the middle of each patch, its pixels traced.
class Hemicube : public ByPixels<Hemicube> {
  public:
    static constexpr EstimatorInfo info = projection({
        .name = "hemicube",
        .summary = "the hemicube over the middle of each patch; a ray through every pixel (Cohen and Greenberg)",
        .details =
            "Half a cube stands on the middle of each patch, aligned with its first edge: r x r pixels on top, "
            "r x r/2 on\neach side. A ray goes through the centre of every pixel, which counts with its delta form "
            "factor, the kernel at\nthe centre times the pixel's area. Deterministic: the error comes from the one "
            "point that stands for the patch\n(it falls with patches_per_face) and from the pixels (aliasing; it falls "
            "about as 1/r). samples_per_patch counts\npixels, 3 r^2 with r even: 768 is r = 16, 786432 is r = 512. "
            "Parallelograms and triangles only.",
        .reference = "cohen1985",
    });

    static constexpr std::string_view sizes = "a hemicube has 3 r^2 pixels, r even";

    using ByPixels::ByPixels;

    static std::uint64_t count(std::uint64_t half_r) { return 12 * half_r * half_r; }
    static std::uint64_t samples_of_resolution(std::uint64_t r) { return r % 2 == 0 ? count(r / 2) : 0; }
    static PixelDirections lay(std::uint64_t half_r);
};

/// The cubic tetrahedron over the middle of each patch, its pixels traced.
class CubicTetrahedron : public ByPixels<CubicTetrahedron> {
  public:
    static constexpr EstimatorInfo info = projection({
        .name = "cubic_tetrahedron",
        .summary = "the corner of a cube over each patch; a ray through every pixel (Beran-Koehn and Pavicic)",
        .details =
            "The corner of a cube, cut off through three others, stands on the middle of each patch, its diagonal "
            "along the\nnormal: three triangles, and no direction is nearer to the horizon on one of them than on "
            "another. A ray goes\nthrough the centre of every pixel, which counts with its delta form factor. As the "
            "hemicube otherwise, with\nr(r - 1)/2 pixels on each triangle, those centred on the horizon left out: "
            "samples_per_patch is 3 r(r - 1)/2,\n1488 for r = 32. Parallelograms and triangles only.",
        .reference = "berankoehn1991",
    });

    static constexpr std::string_view sizes = "a cubic tetrahedron has 3 r (r - 1) / 2 pixels";

    using ByPixels::ByPixels;

    static std::uint64_t count(std::uint64_t r_less_1) { return 3 * (r_less_1 + 1) * r_less_1 / 2; }
    static std::uint64_t samples_of_resolution(std::uint64_t r) { return r > 0 ? count(r - 1) : 0; }
    static PixelDirections lay(std::uint64_t r_less_1);
};

/// One plane over the middle of each patch, its pixels traced.
class SinglePlane : public ByPixels<SinglePlane> {
  public:
    /// Half the width of the plane, over its height.
    static constexpr double reach = 5;

    static constexpr EstimatorInfo info = projection({
        .name = "single_plane",
        .summary = "one plane over the middle of each patch; a ray through every pixel (Sillion and Puech)",
        .details =
            "A square of r x r pixels, ten times as wide as high, lies over the middle of each patch, aligned with "
            "its first\nedge. A ray goes through the centre of every pixel, which counts with its delta form factor. "
            "What is lower than the\nrim of the plane is lost: 3.2 % of what arrives, near the horizon. Large pixels "
            "stand for much just above the\npatch: at equal numbers of pixels the hemicube is finer. Deterministic; "
            "samples_per_patch counts pixels, r^2 with\nr even. Parallelograms and triangles only.",
        .reference = "sillion1989",
    });

    static constexpr std::string_view sizes = "a single plane has r^2 pixels, r even";

    using ByPixels::ByPixels;

    static std::uint64_t count(std::uint64_t half_r) { return 4 * half_r * half_r; }
    static std::uint64_t samples_of_resolution(std::uint64_t r) { return r % 2 == 0 ? count(r / 2) : 0; }
    static PixelDirections lay(std::uint64_t half_r);
};

}  // namespace ff
