#pragma once

#include "core/estimators/rays/pixel_directions.hpp"

#include <cstdint>
#include <string_view>

namespace ff {

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
    static PixelDirections lay(std::uint64_t half_r);
};

}  // namespace ff
