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
    static PixelDirections lay(std::uint64_t half_r);
};

}  // namespace ff
