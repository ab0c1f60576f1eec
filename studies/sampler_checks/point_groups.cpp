#include "studies/sampler_checks/point_groups.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_set>
#include <vector>

namespace ff::studies {
namespace {

constexpr std::uint64_t most_origins = 1024;  // points that are each tried as the origin
constexpr std::uint64_t least_for_net = 16;   // fewer points form groups too easily
constexpr std::uint32_t half_step = 1u << 7;  // half of 2^-24, the last digit that is looked at
constexpr std::uint32_t digits_seen = ~(2 * half_step - 1);

/// Multiples of 1/n modulo 1, one a coordinate.
using Element = std::array<std::uint64_t, max_dimension>;

std::uint64_t key_of(const Element& element) {
    std::uint64_t key = 0;
    for (const std::uint64_t part : element) key = key << 16 | part;
    return key;
}

Element sum(const Element& a, const Element& b, std::uint64_t n) {
    Element result;
    for (std::size_t d = 0; d < max_dimension; ++d) result[d] = (a[d] + b[d]) % n;
    return result;
}

/// Point i less point 0, where that is a multiple of 1/n to within rounding.
std::optional<Element> difference(const samplers::PointSet& set, std::uint64_t which, std::uint64_t i) {
    Element result{};
    for (std::size_t d = 0; d < set.dimension; ++d) {
        const auto row = set.row(which, d);
        const std::uint64_t times_n = std::uint64_t{row[i] - row[0]} * set.points;
        const std::uint64_t nearest = (times_n + (1ull << 31)) >> 32;
        const std::uint64_t at = nearest << 32;
        if ((times_n > at ? times_n - at : at - times_n) > 2 * set.points) return std::nullopt;
        result[d] = nearest % set.points;
    }
    return result;
}

/// A vector over the field of two elements: all digits of a point.
using Digits = std::array<std::uint32_t, max_dimension>;

Digits combine(const Digits& a, const Digits& b) {
    Digits result;
    for (std::size_t d = 0; d < max_dimension; ++d) result[d] = a[d] ^ b[d];
    return result;
}

/// Whether these form a vector space: they are as many different vectors as their span contains.
bool is_space(const std::vector<Digits>& vectors) {
    const auto rank = static_cast<std::size_t>(std::countr_zero(vectors.size()));
    std::vector<Digits> basis;  // each with a leading digit that no later one has
    for (const Digits& vector : vectors) {
        Digits left = vector;
        for (const Digits& one : basis) left = std::min(left, combine(left, one));
        if (left == Digits{}) continue;
        if (basis.size() == rank) return false;
        basis.push_back(left);
    }
    if (basis.size() != rank) return false;
    std::vector<Digits> sorted = vectors;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) == sorted.end();
}

bool is_possible_net(const samplers::PointSet& set) {
    return std::has_single_bit(set.points) && set.points >= least_for_net;
}

}  // namespace

std::optional<std::uint64_t> first_off_lattice(const samplers::PointSet& set, std::uint64_t which) {
    FF_EXPECT(set.points <= most_for_groups && which < set.sets);
    std::vector<Element> group{Element{}};
    std::unordered_set<std::uint64_t> in_group{0};
    std::unordered_set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < set.points; ++i) {
        const auto element = difference(set, which, i);
        if (!element || !seen.insert(key_of(*element)).second) return i;
        std::vector<Element> multiples;  // those that are not in the group
        for (Element multiple = *element; in_group.count(key_of(multiple)) == 0;
             multiple = sum(multiple, *element, set.points)) {
            multiples.push_back(multiple);
            if (group.size() * (multiples.size() + 1) > set.points) return i;
        }
        const std::size_t known = group.size();
        for (const Element& multiple : multiples) {
            for (std::size_t j = 0; j < known; ++j) {
                group.push_back(sum(group[j], multiple, set.points));
                in_group.insert(key_of(group.back()));
            }
        }
    }
    return std::nullopt;
}

bool is_digital(const samplers::PointSet& set, std::uint64_t which) {
    FF_EXPECT(which < set.sets);
    if (!is_possible_net(set)) return false;
    std::vector<Digits> vectors(set.points);
    for (std::size_t d = 0; d < set.dimension; ++d) {
        const auto row = set.row(which, d);
        for (std::size_t i = 0; i < row.size(); ++i) vectors[i][d] = (row[i] ^ row[0]) & digits_seen;
    }
    return is_space(vectors);
}

std::optional<samplers::PointSet> net_before_shift(const samplers::PointSet& set, std::uint64_t which) {
    if (!is_possible_net(set) || set.points > most_for_groups || is_digital(set, which) ||
        !first_off_lattice(set, which))
        return std::nullopt;
    std::vector<Digits> vectors(set.points);
    const std::uint64_t origins = set.points <= most_origins ? set.points : 1;
    for (std::uint64_t origin = 0; origin < origins; ++origin) {
        for (std::size_t d = 0; d < set.dimension; ++d) {
            const auto row = set.row(which, d);
            for (std::size_t i = 0; i < row.size(); ++i)
                vectors[i][d] = (row[i] - row[origin] + half_step) & digits_seen;
        }
        if (!is_space(vectors)) continue;
        samplers::PointSet net{set.points, set.dimension, 1, {}};
        for (std::size_t d = 0; d < set.dimension; ++d)
            for (const Digits& vector : vectors) net.coordinate.push_back(vector[d]);
        return net;
    }
    return std::nullopt;
}

}  // namespace ff::studies
