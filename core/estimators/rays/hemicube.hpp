#pragma once

#include "core/estimators/rays/pixel_directions.hpp"

#include <cstdint>
#include <string_view>

namespace ff {

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
    static PixelDirections lay(std::uint64_t half_r);
};

}  // namespace ff
