#pragma once

namespace ff {

/// A cube in the middle of a larger one, edges parallel: factors between faces of the larger one, seen past the opaque
/// smaller one. Dimensionless, within 1e-17; edges in one unit.
/// Both throw UserError unless 0 < inner < outer.

/// Between opposite faces. For a displacement (u, v), the inner cube blocks a hexagon: the box around the shadows of
/// its two faces without two triangular corners. The box has a closed form (the same as an aperture's); the corners,
/// smooth in four pieces, are integrated by Gauss's rule with 30 x 30 nodes each.
long double nested_cubes_opposite_factor(long double inner, long double outer);

/// Between adjacent faces: by closure, since a face of the outer cube sends (inner / outer)^2 to the inner one, by
/// reciprocity.
long double nested_cubes_adjacent_factor(long double inner, long double outer);

}  // namespace ff
