#pragma once

#include "core/estimators/pixel_directions.hpp"

#include <string>

namespace ff {

/// The hemicube over the middle of each patch, its pixels traced.
class Hemicube : public ByPixels<Hemicube> {
  public:
    static constexpr EstimatorInfo info{
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
        .own_points = true,
        .has_tracer = true,
        .sees_occluders = true,
        .sees_reflections = true,
        .evaluations = "pixels",
    };

    using ByPixels::ByPixels;

    static std::string size_problem(std::uint64_t samples);
    /// @pre samples = 3 r^2, r even
    static PixelDirections pixels(std::uint64_t samples);
};

}  // namespace ff
