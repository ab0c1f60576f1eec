#pragma once

#include "core/geometry/fwd.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ff::test {

/// A rectangle as an interval along each axis, of length 0 along its normal: "0:1 0:2 3:3 -z".
Surface rectangle(const std::string& text);

/// A scene in which every surface is a face of its own, with the labels "1", "2", ...
Scene scene_of(std::vector<Surface> surfaces);

/// Squared diagonal of the box around both surfaces: what the accuracy of exact exchange areas refers to.
double squared_extent(const Surface& a, const Surface& b);

/// Two exchange areas of one pair, each the sum of up to `parts` exact ones: both within the promised 1e-15 of the
/// squared extent for every part.
testing::AssertionResult same_exchange_area(double a, double b, double squared_extent, int parts = 1);

/// The surface moved by `offset`.
Surface translated(Surface surface, const Eigen::Vector3d& offset);

/// Scaled about the origin; factor > 0.
Surface scaled(Surface surface, double factor);

/// Axis 0 becomes axis 1, 1 becomes 2, 2 becomes 0.
Surface axes_rotated(const Surface& surface);

/// The mirror image in the plane where coordinate `axis` is 0.
Surface mirrored(Surface surface, int axis);

}  // namespace ff::test
