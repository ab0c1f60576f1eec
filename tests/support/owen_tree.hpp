#pragma once

#include "core/points.hpp"

#include <cstdint>

namespace ff::test {

/// True nested uniform scrambling of one coordinate (times 2^32) by definition: every node of the binary tree of
/// digits has an independent random bit that swaps its halves or not. Slow; the reference for hash-based scrambling.
/// @see [owen1995]
std::uint32_t nested_uniform(std::uint32_t coordinate, const Stream& stream, std::size_t dimension);

/// Sobol' points so scrambled: fills `block.size` points from `first` on.
void fill_sobol_tree(const Stream& stream, PointIndex first, PointBlock& block);

}  // namespace ff::test
