#include "studies/sampler_checks/structure.hpp"

#include "core/support/contract.hpp"
#include "samplers/point_sets/net_parameter.hpp"
#include "samplers/support/sizes.hpp"
#include "stats/goodness_of_fit/discrepancy.hpp"
#include "studies/sampler_checks/point_groups.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace ff::studies {
namespace {

/// How many of k^d cells hold one point. A point whose cell is undecided counts as alone in its cell.
std::uint64_t count_singles(const samplers::PointSet& set, std::uint64_t which, std::uint64_t k) {
    std::uint64_t most = 0;
    for (const samplers::Sorting& sorting : samplers::sortings(set, which, k)) {
        const auto cells = points_of_cells(sorting, k);
        const auto singles = static_cast<std::uint64_t>(std::ranges::count(cells, 1));
        most = std::max(most, singles + (set.points - sorting.set.points));
    }
    return most;
}

/// The first point with the same value, for each point.
std::vector<std::uint32_t> first_with_value(std::span<const std::uint32_t> row) {
    std::vector<std::uint32_t> order(row.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order,
                      [&](std::uint32_t a, std::uint32_t b) { return row[a] != row[b] ? row[a] < row[b] : a < b; });
    std::vector<std::uint32_t> first(row.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool known = i > 0 && row[order[i]] == row[order[i - 1]];
        first[order[i]] = known ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Whether each point has the value of the one before it.
std::vector<bool> repeats_previous(std::span<const std::uint32_t> row) {
    std::vector<bool> repeats(row.size(), false);
    for (std::size_t i = 1; i < row.size(); ++i) repeats[i] = row[i] == row[i - 1];
    return repeats;
}

CoordinateStructure coordinate_structure(const std::vector<std::uint32_t>& first) {
    CoordinateStructure found;
    std::vector<std::uint64_t> met(first.size(), 0);  // points with the value of this one
    for (std::size_t i = 0; i < first.size(); ++i) {
        found.equal_pairs += met[first[i]]++;
        if (first[i] == i) ++found.values;
        if (i == 0 || first[i] != first[i - 1]) ++found.runs;
    }
    return found;
}

/// Whether one point lies in each of n slices modulo 1, wherever the first begins. Point i in order is then within a
/// slice of i / n, all by the same shift.
bool fills_shifted_slices(std::span<const std::uint32_t> row) {
    if (row.size() > most_for_groups) return false;
    std::vector<std::uint32_t> sorted(row.begin(), row.end());
    std::ranges::sort(sorted);
    const auto n = static_cast<std::int64_t>(row.size());
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::int64_t most = std::numeric_limits<std::int64_t>::min();
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t beyond = sorted[static_cast<std::size_t>(i)] * n - (i << 32);
        least = std::min(least, beyond);
        most = std::max(most, beyond);
    }
    return most - least < std::int64_t{1} << 32;
}

/// The smallest number up to 4 such that in n + this many slices no two points share one; 0 where there is none.
std::uint64_t free_slices(std::span<const std::uint32_t> row) {
    constexpr std::uint64_t most = 4;
    for (std::uint64_t more = 1; more <= most; ++more) {
        std::vector<bool> taken(row.size() + more, false);
        const auto takes = [&](std::uint32_t value) {
            const std::uint64_t slice = value * taken.size() >> 32;
            const bool is_free = !taken[slice];
            taken[slice] = true;
            return is_free;
        };
        if (std::ranges::all_of(row, takes)) return more;
    }
    return 0;
}

}  // namespace

samplers::PointSet projection(const samplers::PointSet& set, std::uint64_t which,
                              const std::vector<std::size_t>& coordinates) {
    samplers::PointSet result{set.points, coordinates.size(), 1, {}};
    for (const std::size_t d : coordinates) {
        const auto row = set.row(which, d);
        result.coordinate.insert(result.coordinate.end(), row.begin(), row.end());
    }
    return result;
}

std::vector<std::uint64_t> points_of_cells(const samplers::Sorting& sorting, std::uint64_t k) {
    const samplers::PointSet& set = sorting.set;
    std::vector<std::uint64_t> counts(samplers::integer_power(k, set.dimension), 0);
    for (std::size_t i = 0; i < set.points; ++i) {
        std::uint64_t cell = 0;
        for (std::size_t d = set.dimension; d-- > 0;)
            cell = cell * k + samplers::part_of(set.row(0, d)[i], k, sorting.edge);
        ++counts[cell];
    }
    return counts;
}

std::uint32_t base_of_structure(std::uint64_t points, std::uint32_t base_of_powers) {
    if (base_of_powers != 0) return base_of_powers;
    for (const std::uint32_t base : {2u, 3u, 5u, 7u, 11u, 13u}) {
        if (samplers::integer_power(base, samplers::count_digits(points, base)) == points) return base;
    }
    return 2;
}

SetStructure structure_of(const samplers::PointSet& set, std::uint64_t which, std::uint32_t base) {
    FF_EXPECT(which < set.sets && set.points >= 1);
    SetStructure found;
    std::vector<std::vector<bool>> repeats;
    for (std::size_t d = 0; d < set.dimension; ++d) {
        repeats.push_back(repeats_previous(set.row(which, d)));
        CoordinateStructure& coordinate =
            found.coordinates.emplace_back(coordinate_structure(first_with_value(set.row(which, d))));
        coordinate.repeats_as = static_cast<std::size_t>(std::ranges::find(repeats, repeats.back()) - repeats.begin());
        coordinate.free_slices = free_slices(set.row(which, d));
        coordinate.fills_shifted = fills_shifted_slices(set.row(which, d));
        coordinate.single_slices = count_singles(projection(set, which, {d}), 0, set.points);
    }
    const std::uint64_t k = samplers::floor_root(set.points, set.dimension);
    if (set.dimension > 1 && k > 1 && samplers::integer_power(k, set.dimension) == set.points) {
        found.cells_a_side = k;
        found.single_cells = count_singles(set, which, k);
    }
    if (set.points <= most_for_groups) found.lattice = !first_off_lattice(set, which);
    if (set.points > most_for_t_of_structure) return found;
    found.t = samplers::net_parameter(set, which, base);
    if (!found.t || set.dimension < 3) return found;
    for (std::size_t a = 0; a < set.dimension; ++a) {
        for (std::size_t b = a + 1; b < set.dimension; ++b) {
            const auto t = samplers::net_parameter(projection(set, which, {a, b}), 0, base);
            found.pairs.push_back({a, b, t.value_or(0)});
        }
    }
    return found;
}

EvennessOfSet evenness_of(const samplers::PointSet& set, std::uint32_t base) {
    EvennessOfSet found;
    stats::Coordinates coordinates(set.dimension);
    for (std::size_t d = 0; d < set.dimension; ++d) {
        for (const std::uint32_t x : set.row(0, d)) coordinates[d].push_back((x + 0.5) * 0x1p-32);
        found.largest_gap = std::max(found.largest_gap, stats::largest_gap(coordinates[d]));
    }
    if (set.points <= most_for_t_value) found.t_value = samplers::net_parameter(set, 0, base);
    if (set.points <= most_quadratic) {
        found.l2_star_discrepancy = stats::l2_star_discrepancy(coordinates);
        found.centred_discrepancy = stats::centred_discrepancy(coordinates);
    }
    return found;
}

}  // namespace ff::studies
