#pragma once

#include "core/estimators/rays/pixel_directions.hpp"

#include <cstdint>
#include <string_view>

namespace ff {

/// The cubic tetrahedron over the middle of each patch, its pixels traced.
class CubicTetrahedron : public ByPixels<CubicTetrahedron> {
  public:
    static constexpr EstimatorInfo info = projection({
        .name = "cubic_tetrahedron",
        .summary = "the corner of a cube over each patch; a ray through every pixel (Beran-Koehn and Pavicic)",
        .details =
            "The corner of a cube, cut off through three others, stands on the middle of each patch, its diagonal "
            "along "
            "the\nnormal: three triangles, and no direction is nearer to the horizon on one of them than on another. "
            "A ray goes\nthrough the centre of every pixel, which counts with its delta form factor. As the hemicube "
            "otherwise, with\nr(r - 1)/2 pixels on each triangle, those centred on the horizon left out: "
            "samples_per_patch is 3 r(r - 1)/2,\n1488 for r = 32. Parallelograms and triangles only.",
        .reference = "berankoehn1991",
    });

    static constexpr std::string_view sizes = "a cubic tetrahedron has 3 r (r - 1) / 2 pixels";

    using ByPixels::ByPixels;

    static std::uint64_t count(std::uint64_t r_less_1) { return 3 * (r_less_1 + 1) * r_less_1 / 2; }
    static PixelDirections lay(std::uint64_t r_less_1);
};

}  // namespace ff
