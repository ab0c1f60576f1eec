#pragma once

#include "core/points/stream.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ff {

inline constexpr std::size_t max_dimension = 4;

/// Points that fit one block: 16 KiB of coordinates, so that a block stays in the first-level cache.
inline constexpr std::size_t block_capacity = 1024;

/// Position of a point in its sequence, from 0. At most 2^32 points in a stream.
using PointIndex = std::uint64_t;

/// Consecutive points of a sequence in fixed point: coordinate[d][i] * 2^-32 in [0, 1).
///
/// Only the first `dimension` rows and `size` columns are meaningful; writers may fill a row up to one whole vector
/// past `size` (the capacity is a multiple of every vector length).
struct PointBlock {
    alignas(64) std::array<std::array<std::uint32_t, block_capacity>, max_dimension> coordinate;
    std::size_t dimension = max_dimension;
    std::size_t size = 0;  ///< set by the caller before `fill`: how many points it wants
};

/// Consecutive points with weights: an integral over [0,1)^d is the sum over all points of weight * f.
struct WeightedBlock {
    alignas(64) std::array<std::array<double, block_capacity>, max_dimension> coordinate;
    alignas(64) std::array<double, block_capacity> weight;
    std::size_t dimension = max_dimension;
    std::size_t size = 0;
};

/// Where an estimator gets its points. Point i is a pure function of (stream, i); see samplers/sampler.hpp.
class PointSource {
  public:
    virtual ~PointSource() = default;

    /// Number of points of the set; the weights of a WeightedBlock refer to it.
    [[nodiscard]] virtual std::uint64_t points() const = 0;
    /// False where every stream gives the same points, so that repeated trials would be equal.
    [[nodiscard]] virtual bool randomised() const = 0;
    /// False where points have unequal weights and cannot be tallied as hits.
    [[nodiscard]] virtual bool equal_weights() const = 0;
    /// True where swapping source and target coordinates (0, 1 with 2, 3) leaves the weighted set unchanged, so that
    /// one evaluation of a symmetric kernel serves both (i, j) and (j, i).
    [[nodiscard]] virtual bool exchangeable() const { return false; }

    /// Estimators call this at least between any two patches for which they request no points. A source may throw to
    /// end a trial that is no longer wanted.
    virtual void checkpoint() const {}

    /// Fills `block.size` points from `first` on. @pre equal_weights()
    virtual void fill(const Stream& stream, PointIndex first, PointBlock& block) const = 0;
    /// Fills points in double precision, with weights. An equal-weight point is the centre of its 2^-32 cell: sources
    /// of such points do with this implementation.
    virtual void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const {
        PointBlock cells;
        cells.dimension = block.dimension;
        cells.size = block.size;
        fill(stream, first, cells);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i)
                block.coordinate[d][i] = (cells.coordinate[d][i] + 0.5) * 0x1p-32;
        }
        std::fill_n(block.weight.begin(), block.size, 1.0 / static_cast<double>(points()));
    }

  protected:
    PointSource() = default;
    PointSource(const PointSource&) = default;
    PointSource& operator=(const PointSource&) = default;
    PointSource(PointSource&&) = default;
    PointSource& operator=(PointSource&&) = default;
};

/// Fills a block again and again with `count` points from `first` on, and calls visit(index of its first point).
template <class Block, class Visit>
void for_each_block(const PointSource& points, const Stream& stream, PointIndex first, std::uint64_t count,
                    Block& block, const Visit& visit) {
    for (std::uint64_t done = 0; done < count; done += block.size) {
        block.size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, count - done));
        points.fill(stream, first + done, block);
        visit(first + done);
    }
}

}  // namespace ff
