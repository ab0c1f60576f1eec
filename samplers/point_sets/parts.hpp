#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <vector>

namespace ff::samplers {

/// A coordinate is known only up to a cell of width 2^-32. Where a cell lies in two parts, one of its ends decides
/// which part the point is in.
enum class Edge { upper, lower };

/// Which of so many equal parts of [0, 1) a coordinate is in. With `upper`, a point made on a boundary, such as i / 3,
/// is in the part that begins there. @pre parts <= 2^32
constexpr std::uint64_t part_of(std::uint32_t x, std::uint64_t parts, Edge edge = Edge::upper) {
    return edge == Edge::upper ? ((x + std::uint64_t{1}) * parts - 1) >> 32 : x * parts >> 32;
}

/// One way to sort the points of a set into parts.
struct Sorting {
    PointSet set;  ///< a single set, without the points whose part is undecided
    Edge edge = Edge::upper;
};

/// The ways to sort a set into parts, or into fewer parts that each consist of some of these: a set has a structure
/// where it has it in one of these ways. The first counts all points at the upper end of their cells. The second, where
/// a cell lies in two parts, leaves out the points of such cells, if they are as few as chance would have it; if they
/// are many, they lie there by a rule, and all are counted at the lower end. @pre which < set.sets, parts <= 2^32
std::vector<Sorting> sortings(const PointSet& set, std::uint64_t which, std::uint64_t parts);

}  // namespace ff::samplers
