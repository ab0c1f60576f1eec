#pragma once

#include "core/estimators/rays/ray_shooting.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ff {

/// Directions through the centres of the pixels of a projection, as seen from a patch, and the form factor that each
/// pixel stands for. Axes: x along the patch's first edge, z along its normal.
class PixelDirections {
  public:
    explicit PixelDirections(std::uint64_t expected);

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
class PixelProjection {
  public:
    PixelProjection(const Scene& scene, TracerChoice tracer);

    /// Form factors between faces: for each patch, the sum over the pixels that show the other face.
    [[nodiscard]] Eigen::MatrixXd factors(Subdivision subdivision, const PixelDirections& pixels) const;

    static constexpr auto refusal = &RayShooting::refusal;
    static double nanoseconds(const EstimatorOptions& options, const Scene& scene);

  protected:
    /// "(a hemicube has 3 r^2 pixels, r even). Try 768 or 1200."
    static std::string no_such_size(std::string_view rule, std::uint64_t below, std::uint64_t above);

  private:
    const Scene* scene_;
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

}  // namespace ff
