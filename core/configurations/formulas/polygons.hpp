#pragma once

namespace ff {

/// Factors between plane polygons by contour integrals (core/formulas/polygon_exchange.hpp) in extended precision,
/// within about 1e-17. Lengths in one unit.

/// Between two rectangles that share a whole edge: `from` and `to` are their widths across it, the angle between them
/// is in radians, strictly between 0 and pi. @see [howell] C-16   @throws UserError for other values
long double rectangles_at_angle_factor(long double edge, long double from, long double to, long double angle);

/// Between the right triangles (0,1,1) (1,1,1) (1,0,1) and (1,0,0) (1,1,0) (0,1,0): the same half of two opposite faces
/// of a unit cube.
long double parallel_right_triangles_factor();

/// Between two faces of a regular tetrahedron; by symmetry and closure 1/3.
long double tetrahedron_factor();

}  // namespace ff
