#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace ff {

/// What the patches of one surface exchange with those of another.
struct PatchExchange {
    Eigen::MatrixXd areas;     ///< exchange areas A_i F_ij, [patch of the first][patch of the second]
    double error = 0;          ///< upper bound of the error of any entry, in the same unit
    std::size_t computed = 0;  ///< entries that were computed; the others are equal to one of them
};

/// Exchange areas of all pairs of patches of two parallelograms, nothing between them: by closed form for rectangles
/// along the axes, by contour integrals (core/formulas/polygon_exchange.hpp) for others. Pairs in the same relative
/// position are computed once: (2m-1)^2 of m^4 between parallel surfaces with equal patches, (2m-1) m^2 between
/// surfaces that share an edge, where both have m x m patches. Of patches that reach behind the other surface, only the
/// part in front counts. The error is a bound, except that the rounding of contour integrals is estimated.
PatchExchange patch_exchange(const Surface& from, const Surface& to, Subdivision subdivision);

}  // namespace ff
