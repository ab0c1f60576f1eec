#pragma once

#include "core/geometry/scene.hpp"
#include "core/points/points.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace ff {

/// Weighted pairs of points on two patches, as vectors from the point on the one to the point on the other when both
/// patches have their corner at the origin. Padded with zeros to a multiple of eight.
struct Separations {
    using Component = std::array<double, block_capacity>;
    alignas(64) Component x, y, z, weight;
    std::size_t size = 0;  ///< multiple of 8
};

/// The pairs that a block of 4-D points (two coordinates on `from`, two on `to`) stands for.
void separate(const Parallelogram& from, const Parallelogram& to, const WeightedBlock& points, Separations& pairs);

/// Unit normals of the two patches.
struct Normals {
    Eigen::Vector3d from, to;
};

/// The sum over `offsets` (corner to corner) and over pairs of weight * cos_from * cos_to / r^2, in 1 / length^2.
/// Cosines of points behind a patch count as 0, and so do points that coincide.
/// Terms are added in eight columns whatever the vector length, so every CPU gives the same bits.
/// @param each  where not empty, the sum of offset k by itself is added to its element k
double sum_transfer(const Separations& pairs, std::span<const Eigen::Vector3d> offsets, const Normals& normals,
                    std::span<double> each = {});

}  // namespace ff
