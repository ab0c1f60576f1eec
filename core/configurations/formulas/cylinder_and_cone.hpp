#pragma once

namespace ff {

/// Insides of right circular cylinders and cones, also with a smaller cylinder on the same axis. Factors are
/// dimensionless, lengths in one unit. All throw UserError for lengths that are not positive and finite.

/// From the wall of a cylinder to itself: 1 + H - sqrt(1 + H^2) with H = height / 2 radius. @see [howell]
long double cylinder_wall_to_itself_factor(long double radius, long double height);

/// From a base of a cylinder to its wall: by reciprocity and closure 2 H / (H + sqrt(1 + H^2)), H as above. The
/// remainder reaches the other base (`coaxial_discs_factor`). @see [howell]
long double cylinder_base_to_wall_factor(long double radius, long double height);

/// From the wall of a cone to itself: all that leaves its base reaches the wall, the rest follows by reciprocity and
/// closure, 1 - radius / slant height. @see [howell]
long double cone_wall_to_itself_factor(long double radius, long double height);

/// From the inside of a cylinder to the outside of a smaller one, coaxial and as high. @see [howell]
/// Throws UserError unless inner < outer.
long double outer_cylinder_to_inner_factor(long double inner, long double outer, long double height);

/// From the inside of a cylinder to itself, past the opaque smaller one. @see [howell]
/// Throws UserError unless inner < outer.
long double outer_cylinder_to_itself_factor(long double inner, long double outer, long double height);

}  // namespace ff
