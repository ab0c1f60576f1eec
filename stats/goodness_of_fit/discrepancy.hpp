#pragma once

#include <span>
#include <vector>

namespace ff::stats {

/// Coordinates in [0, 1), [dimension][point]; as many points in each dimension.
using Coordinates = std::vector<std::vector<double>>;

/// Star discrepancy in the L2 norm, by Warnock's formula, in O(n^2 d) [niederreiter1992]. @pre at least one point
double l2_star_discrepancy(const Coordinates& points);

/// Centred L2 discrepancy, invariant under reflection of coordinates, in O(n^2 d) [hickernell1998].
double centred_discrepancy(const Coordinates& points);

/// The longest interval of an axis that contains no coordinate of a point, including the one that wraps around at 1.
double largest_gap(std::span<const double> coordinates);

}  // namespace ff::stats
