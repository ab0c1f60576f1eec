#pragma once

namespace ff {

/// Discs on a common axis, in planes at right angles to it, facing each other. Lengths in one unit; factors are
/// dimensionless, accurate to a few units in the last place of a long double. All throw UserError for lengths that are
/// not positive and finite.

/// From the disc of radius r1 to the disc of radius r2, `distance` apart. @see [howell] C-41
long double coaxial_discs_factor(long double r1, long double r2, long double distance);

/// From an element of area at the foot of the axis, parallel to the disc. @see [howell] B-12
long double element_to_disc_factor(long double radius, long double distance);

/// A disc that stands between the two, on the same axis.
struct DiscBlocker {
    long double radius = 0;
    long double distance = 0;  ///< from the first disc
};

/// From the disc of radius r1 to the one of radius r2 past an opaque disc, where the blocker's whole shadow falls on
/// the second disc: the result is then F12 - F1b, since exactly what reaches the blocker is lost.
/// @throws UserError also where the blocker's shadow reaches beyond the second
/// disc
long double blocked_coaxial_discs_factor(long double r1, long double r2, long double distance, DiscBlocker blocker);

}  // namespace ff
