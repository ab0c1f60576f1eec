#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <optional>

namespace ff::studies {

inline constexpr std::uint64_t most_for_groups = 1u << 16;

/// A lattice of n points is a shifted group modulo 1 of multiples of 1/n. Finds the first point that does not fit into
/// the lattice of the points before it, or that occurs twice; empty where the set is a lattice. Coordinates may be off
/// by a rounding to 2^-32. @pre which < set.sets, set.points <= most_for_groups
std::optional<std::uint64_t> first_off_lattice(const samplers::PointSet& set, std::uint64_t which);

/// Whether the set is a digital net in base 2, up to a digital shift: the differences of points, by exclusive or, are a
/// group. Digits beyond the 24th are not looked at. @pre which < set.sets
bool is_digital(const samplers::PointSet& set, std::uint64_t which);

/// A digital net in base 2 that a shift modulo 1 has turned into this set, which is neither digital nor a lattice; its
/// first point is the origin. Empty where there is none, and where the set is too large to try every origin.
/// @pre which < set.sets
std::optional<samplers::PointSet> net_before_shift(const samplers::PointSet& set, std::uint64_t which);

}  // namespace ff::studies
