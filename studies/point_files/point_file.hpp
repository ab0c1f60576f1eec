#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Reads sets of points in one of four forms:
///
/// - NumPy (.npy): (n, d) or (trials, n, d) of float32 or float64 in [0, 1), or of uint32, which count 2^-32;
/// - raw: the 8 bytes FFPOINTS, n and d as 64-bit integers, n * d float64 point by point; all little-endian;
/// - text: a point a line, numbers in [0, 1) separated by spaces, tabs or commas; a line that begins with # ends a set;
/// - LDData text of a rank-1 lattice (`# lattice`) or of a digital net in base 2 (`# dnet`, `# dnetup`); of more than
///   2^22 points, the first ones.
///
/// Coordinates past the fourth are left out: no estimator takes them.
/// @param origin  names the file in messages
/// @throws UserError with origin, and set, point and coordinate or the line
samplers::PointSet parse_points(std::string_view bytes, const std::string& origin);

/// Total bytes of a raw set, from its beginning; for anything else, the bytes at hand.
std::uint64_t raw_size(std::string_view beginning);

// LDData.
bool is_ld_data(std::string_view text);
samplers::PointSet parse_ld_data(std::string_view text, const std::string& origin);
/// Powers of 2 below the size of a set such that its first points are spread as evenly in every coordinate as the whole
/// set: one in each interval.
std::vector<std::uint64_t> nested_sizes(const samplers::PointSet& set);

}  // namespace ff::studies
