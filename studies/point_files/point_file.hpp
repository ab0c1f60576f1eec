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

// One function per format.
bool is_npy(std::string_view bytes);
samplers::PointSet parse_npy(std::string_view bytes, const std::string& origin);
bool is_raw(std::string_view bytes);
/// Total bytes of a raw set, from its beginning; for anything else, the bytes at hand.
std::uint64_t raw_size(std::string_view beginning);
samplers::PointSet parse_raw(std::string_view bytes, const std::string& origin);
bool is_ld_data(std::string_view text);
samplers::PointSet parse_ld_data(std::string_view text, const std::string& origin);
/// Powers of 2 below the size of a set such that its first points are spread as evenly in every coordinate as the whole
/// set: one in each interval.
std::vector<std::uint64_t> nested_sizes(const samplers::PointSet& set);

/// x * 2^32. @throws UserError unless 0 <= x < 1, with the place counted from 0
std::uint32_t fixed_point(double x, const std::string& origin, std::uint64_t set, std::uint64_t point, std::size_t d);

/// @throws UserError for a size that no set has
void expect_size(const std::string& origin, std::uint64_t sets, std::uint64_t points, std::uint64_t dimension);

}  // namespace ff::studies
