#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace ff {

/// What the patches of one surface exchange with those of another.
struct PatchExchange {
    Eigen::MatrixXd areas;     ///< exchange areas A_i F_ij, [patch of the first][patch of the second]
    double error = 0;          ///< that no entry is off by more than, in the same unit
    std::size_t computed = 0;  ///< entries that were computed; the others are equal to one of them
};

/// Exchange areas of all pairs of patches of two parallelograms, nothing between them: by closed form for rectangles
/// along the axes, by contour integrals (core/formulas/polygon_exchange.hpp) for others. Pairs that lie to each other
/// as another pair does are computed once: (2m-1)^2 of m^4 between parallel surfaces with equal patches, (2m-1) m^2
/// between surfaces that share an edge, where both have m x m patches. Patches that reach behind the other surface
/// count with the part in front. The error is a bound, but for the rounding of contour integrals, which is an estimate.
PatchExchange patch_exchange(const Surface& from, const Surface& to, Subdivision subdivision);

}  // namespace ff
