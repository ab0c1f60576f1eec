#pragma once

#include "core/geometry/subdivision.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace ff {

/// Exact form factors by elementary formulas: axis-aligned rectangles in parallel or perpendicular planes, in any
/// relative position, overlapping or offset, with or without a common edge or corner. Only the parts in front of each
/// other's `normal` side count. Callers have to know that nothing stands in between, except for whole matrices, which
/// are empty where something may. In a box with mirrors (core/visibility/mirrors.hpp) factors between faces are
/// extended ones, found by images: direct or by way of mirrors.

/// Exchange area A_1 F_12, in squared units of length, within 1e-15 of the squared extent: the squared diagonal of the
/// box around both surfaces (measured: at most 1.3e-16 over 18 000 random pairs). The error is not relative to the
/// result: fewer digits are right for two small surfaces far apart. Symmetric up to this error.
/// @return empty unless both are rectangles along the axes
/// @see [howell] C-11 to C-15, [ehlert1993]
std::optional<double> exact_exchange_area(const Surface& from, const Surface& to);

/// Exchange area in extended precision: within 1e-18 of the squared extent where the machine has it, apart from the
/// rounding of the result.
std::optional<double> extended_exchange_area(const Surface& from, const Surface& to);

/// Squared diagonal of the box around two polygons: errors of exchange areas are relative to it.
double squared_extent(const Surface& from, const Surface& to);

/// Form factor between two faces. This and the functions below compute in extended precision where the machine has it,
/// some ten times slower: exchange areas are within 1e-18 of the squared extent, so that factors between faces that are
/// not far apart are right to the last digits of a double.
/// @return empty where some pair of surfaces has no elementary formula
/// @pre both are indices into scene.faces
std::optional<double> exact_form_factor(const Scene& scene, int from_face, int to_face);

/// Factors from every patch (rows, in the order of PatchOrder; 0 of surfaces without a face) to every face (columns).
/// Empty as above, and where something may stand between two surfaces (core/visibility/occlusion.hpp).
std::optional<Eigen::MatrixXd> exact_patch_to_face(const Scene& scene, Subdivision subdivision);

/// Factors from every face (rows) to every face (columns). Empty as above, and where something may stand in between.
std::optional<Eigen::MatrixXd> exact_form_factors(const Scene& scene);

/// The exchange areas of the patches of one surface and those of another.
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
