#pragma once

#include "core/estimators/estimator.hpp"
#include "core/geometry/scene.hpp"
#include "core/points/points.hpp"
#include "core/visibility/touching.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace ff {

/// Where patches touch, the kernel cos cos / (pi r^2) is unbounded. The graded map replaces a coordinate s that leads
/// away from the contact by s^power and multiplies the weight by power * s^(power - 1):
/// - at a common edge, the distance from it on either patch, power 3: kernel times weight has tail index 5/2 (3/2
///   without the map), so that its variance is finite, and its fourth moment is not;
/// - at a common vertex, both coordinates on either patch, power 2: kernel times weight is bounded (index 2 without).
/// Other contacts, which do not occur between patches of a box, are left alone.

/// The index of P(kernel * weight > x) ~ x^-index with random points; empty where it is bounded. Variance is finite
/// above 2.
std::optional<double> kernel_tail_index(Contact contact, PointMap map);

/// Whether the kernel at random points on two faces (numbered from 0) has a finite variance: it does not where two of
/// their patches touch such that the tail index is 2 or less. Points are graded only between parallelograms, and not
/// where occlusion is tested point by point.
bool kernel_has_variance(const Scene& scene, int from, int to, PointMap map);

/// Two patches whose contact is at 0 of the graded coordinates, so that small distances keep their digits.
struct GradedPair {
    Parallelogram from;
    Parallelogram to;
    std::array<std::uint32_t, 4> power{1, 1, 1, 1};
};

/// Empty where there is nothing to grade.
std::optional<GradedPair> grade_pair(const Parallelogram& from, const Parallelogram& to);

/// Moves the coordinates of a block of 4-D points and changes their weights.
void grade_points(const std::array<std::uint32_t, 4>& power, WeightedBlock& block);

}  // namespace ff
