#pragma once

#include "samplers/point_sets/parts.hpp"
#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies {

/// Facts about one coordinate of n points.
struct CoordinateStructure {
    std::uint64_t values = 0;         ///< number of different values; n where none occurs twice
    std::uint64_t equal_pairs = 0;    ///< pairs of points with the same value
    std::uint64_t runs = 0;           ///< runs of successive points with the same value
    std::size_t repeats_as = 0;       ///< the first coordinate with the same runs
    std::uint64_t single_slices = 0;  ///< slices that hold one point, of n equal ones
    std::uint64_t free_slices = 0;    ///< 1 to 4, where no two points share one of n + this many slices; else 0
    bool fills_shifted = false;       ///< n slices that begin elsewhere than at 0 hold a point each; n <= 2^16
};

/// The t-value of two coordinates.
struct PairStructure {
    std::size_t first = 0;
    std::size_t second = 0;
    std::uint32_t t = 0;
};

/// Facts about one point set; nothing in it is a judgement.
struct SetStructure {
    std::vector<CoordinateStructure> coordinates;
    std::uint64_t cells_a_side = 0;    ///< k where n = k^d, d > 1; else 0
    std::uint64_t single_cells = 0;    ///< cells that hold one point, of these n
    std::optional<std::uint32_t> t;    ///< empty where n is not a power of the base, or is large
    std::vector<PairStructure> pairs;  ///< one for every two coordinates, where `t` is set and d > 2
    bool lattice = false;              ///< false for very large sets, too
};

inline constexpr std::uint64_t most_for_t_of_structure = 1u << 14;

/// @param base  of t-values  @pre which < set.sets, set.points >= 1
SetStructure structure_of(const samplers::PointSet& set, std::uint64_t which, std::uint32_t base);

/// The set without all coordinates but these. @pre each is below set.dimension, which < set.sets
samplers::PointSet projection(const samplers::PointSet& set, std::uint64_t which,
                              const std::vector<std::size_t>& coordinates);

/// How many points each of k^d cells holds; those of one coordinate are slices.
std::vector<std::uint64_t> points_of_cells(const samplers::Sorting& sorting, std::uint64_t k);

/// The base of t-values: that of the sampler, if it is made for powers; otherwise 2, or the smallest of 3, 5, 7, 11 and
/// 13 of which the number of points is a power.
std::uint32_t base_of_structure(std::uint64_t points, std::uint32_t base_of_powers);

/// Measures of the evenness of a point set: the smaller, the more even.
struct EvennessOfSet {
    std::optional<std::uint32_t> t_value;       ///< empty unless the number of points is a small power of the base
    std::optional<double> l2_star_discrepancy;  ///< empty for more than `most_quadratic` points
    std::optional<double> centred_discrepancy;  ///< empty for more than `most_quadratic` points
    double largest_gap = 0;                     ///< widest gap between neighbours on any axis
};

inline constexpr std::uint64_t most_quadratic = 1u << 14;
inline constexpr std::uint64_t most_for_t_value = 1u << 16;

/// @param base  of the t-value
EvennessOfSet evenness_of(const samplers::PointSet& set, std::uint32_t base);

}  // namespace ff::studies
