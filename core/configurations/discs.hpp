#pragma once

namespace ff {

/// Discs on a common axis, in planes at right angles to it, facing each other. Lengths in one unit; factors are
/// dimensionless, with a few units of rounding of a long double relative to the result.
/// All throw UserError for lengths that are not positive and finite.

/// From the disc of radius r1 to the one of radius r2 at a distance. @see [howell] C-41
long double coaxial_discs_factor(long double r1, long double r2, long double distance);

/// From an element of area at the foot of the axis, parallel to the disc. @see [howell] B-12
long double element_to_disc_factor(long double radius, long double distance);

/// A disc that stands between the two, on the same axis.
struct DiscBlocker {
    long double radius = 0;
    long double distance = 0;  ///< from the first disc
};

/// From the disc of radius r1 to the one of radius r2 past an opaque disc, where the blocker's whole shadow falls on
/// the second disc: what reaches the blocker is then just what is missing, F12 - F1b.
/// @throws UserError also where light passes by the blocker's edge to beyond the second disc, so that this does not
/// hold
long double blocked_coaxial_discs_factor(long double r1, long double r2, long double distance, DiscBlocker blocker);

}  // namespace ff
