#pragma once

namespace ff {

/// Spheres and parts of them. Factors are dimensionless, lengths in one unit.
/// All throw UserError for lengths that are not positive and finite.

/// From a sphere to a disc whose axis passes through the sphere's centre, `distance` from the disc. The sphere may have
/// any radius that keeps it on its side of the disc: a sphere radiates like a point, so this is the disc's share of all
/// directions from the centre. @see [howell]
long double sphere_to_disc_factor(long double disc_radius, long double distance);

/// Inside a sphere, from any part of it (the cap included) to a cap of this height: every part receives its share of
/// the total area, h / 2R. A hemisphere is a cap of height R. @see [howell]
/// @throws UserError where the cap is higher than the sphere
long double sphere_cap_factor(long double sphere_radius, long double cap_height);

/// From the inside of the outer of two concentric spheres to itself, past the opaque inner one.
/// By reciprocity and closure: 1 - (inner / outer)^2. @throws UserError unless inner < outer
long double outer_sphere_to_itself_factor(long double inner_radius, long double outer_radius);

}  // namespace ff
