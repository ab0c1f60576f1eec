#include "samplers/support/sizes.hpp"
#include "stats/basics/binomial.hpp"
#include "studies/sampler_checks/structure_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

// With 2^16 values, two of the 256 points that a check usually takes share one with a probability of 0.4.
constexpr std::uint64_t few_values = 1u << 16;
constexpr std::size_t least_on_grid = 6;  // the grid is chosen by them: fewer lie on one by chance

/// Repeats and common values of every coordinate share a third of `false_doubts`.
double level_of_each(const StructureEvidence& evidence) {
    return false_doubts / (6 * static_cast<double>(evidence.drawn.dimension));
}

/// Whether there are more pairs of points with equal values, in all sets, than values of 32 bits have by chance.
bool repeats_values(const StructureEvidence& evidence, std::size_t d) {
    const std::uint64_t n = evidence.drawn.points;
    std::uint64_t equal = 0;
    for (const SetStructure& set : evidence.sets) equal += set.coordinates[d].equal_pairs;
    const std::uint64_t pairs = evidence.sets.size() * (n * (n - 1) / 2);
    if (equal == 0 || pairs == 0) return false;
    return stats::binomial_upper_p({equal, pairs}, 0x1p-32) < level_of_each(evidence);
}

/// Whether consecutive points share all coordinates but the last one or two: an origin with several directions.
bool shares_origins(const StructureEvidence& evidence, const std::vector<std::size_t>& repeating) {
    const std::size_t dimension = evidence.drawn.dimension;
    if (repeating.size() + 1 != dimension && repeating.size() + 2 != dimension) return false;
    if (repeating.back() + 1 != repeating.size()) return false;
    for (const std::size_t d : repeating) {
        std::uint64_t apart = 0;  // runs with the value of an earlier one, which chance may give
        std::uint64_t pairs = 0;
        for (const SetStructure& set : evidence.sets) {
            const CoordinateStructure& one = set.coordinates[d];
            if (one.repeats_as != 0) return false;
            apart += one.runs - one.values;
            pairs += one.runs * (one.runs - 1) / 2;
        }
        if (apart > 0 && stats::binomial_upper_p({apart, pairs}, 0x1p-32) < level_of_each(evidence)) return false;
    }
    return true;
}

bool has_lattice(const std::vector<Promise>& kept) {
    return std::count(kept.begin(), kept.end(), Promise{PromiseKind::lattice}) > 0;
}

/// Whether this many values per coordinate are those of a regular grid with one point in each of its cells.
bool is_grid(const StructureEvidence& evidence, const std::vector<Promise>& kept, std::uint64_t values) {
    return std::count(kept.begin(), kept.end(), Promise{PromiseKind::stratified}) > 0 &&
           values == samplers::floor_root(evidence.drawn.points, evidence.drawn.dimension);
}

/// M where all values lie on a grid of M equal steps from 0 to 1, to within rounding to 2^-32, and neighbours in it
/// occur; else 0. @pre ascending, each once
std::uint64_t steps_of_grid(const std::vector<std::uint32_t>& values) {
    std::uint64_t gap = std::uint64_t{1} << 32;
    for (std::size_t i = 1; i < values.size(); ++i) gap = std::min<std::uint64_t>(gap, values[i] - values[i - 1]);
    const std::uint64_t steps = ((std::uint64_t{1} << 32) + gap / 2) / gap;
    for (const std::uint32_t x : values) {
        const std::uint64_t scaled = std::uint64_t{x - values.front()} * steps;
        const auto beyond = static_cast<std::uint32_t>(scaled);
        if (std::min(beyond, 0u - beyond) > 2 * steps) return 0;
    }
    return steps;
}

/// Whether numbers with a few bits or decimals have this many steps: 2^k, 2^k - 1 (an integer divided by the largest
/// one) or 10^k. Other grids are those of radical inverses and lattices, which have more structure than single values.
bool is_of_short_numbers(std::uint64_t steps) {
    std::uint64_t tenths = steps;
    while (tenths % 10 == 0) tenths /= 10;
    return tenths == 1 || std::has_single_bit(steps) || std::has_single_bit(steps + 1);
}

/// Values of one coordinate that different sets have in common.
struct CommonValues {
    std::vector<std::uint32_t> values;  ///< values in any of the sets, ascending, each once
    std::uint64_t sharing = 0;          ///< pairs of sets with a value in common
};

CommonValues common_values(const StructureEvidence& evidence, std::size_t d) {
    const samplers::PointSet& drawn = evidence.drawn;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> values;  // with their set
    for (std::uint32_t set = 0; set < drawn.sets; ++set) {
        for (const std::uint32_t x : drawn.row(set, d)) values.emplace_back(x, set);
    }
    std::sort(values.begin(), values.end());
    CommonValues found;
    std::vector<bool> in_common(drawn.sets * drawn.sets, false);
    for (auto first = values.begin(); first != values.end();) {
        const auto last = std::find_if(first, values.end(), [&](const auto& one) { return one.first != first->first; });
        found.values.push_back(first->first);
        std::vector<std::uint32_t> sets;
        for (; first != last; ++first) {
            if (sets.empty() || sets.back() != first->second) sets.push_back(first->second);
        }
        for (std::size_t a = 0; a < sets.size(); ++a)
            for (std::size_t b = a + 1; b < sets.size(); ++b) in_common[sets[a] * drawn.sets + sets[b]] = true;
    }
    found.sharing = static_cast<std::uint64_t>(std::count(in_common.begin(), in_common.end(), true));
    return found;
}

/// Values of a randomised sampler lie anywhere, so that independent sets have next to none in common. Those of a coarse
/// grid are in doubt; a randomisation that has few outcomes is worth a note.
std::optional<SamplerCheck> doubt_grid(const StructureEvidence& evidence, const std::vector<Promise>& kept,
                                       std::size_t d) {
    const auto points = static_cast<double>(evidence.drawn.points);
    const std::uint64_t sets = evidence.drawn.sets;
    if (sets < 2) return std::nullopt;
    const CommonValues common = common_values(evidence, d);
    const double by_chance = std::min(1.0, points * points * 0x1p-32);  // an upper bound for each pair of sets
    const bool meet = common.sharing > 0 && stats::binomial_upper_p({common.sharing, sets * (sets - 1) / 2},
                                                                    by_chance) < level_of_each(evidence);
    const std::uint64_t steps = steps_of_grid(common.values);
    // Each value of 32 bits lies near a grid of 2^16 steps with a probability of 2^-13 at most.
    const bool coarse = steps != 0 && steps <= few_values && common.values.size() >= least_on_grid;
    if (!meet && !coarse) return std::nullopt;
    if (coarse) {
        const bool explained =
            (has_lattice(kept) && evidence.drawn.points % steps == 0) || is_grid(evidence, kept, steps);
        const bool doubtful = !explained && is_of_short_numbers(steps);
        return SamplerCheck{"values", doubtful ? SamplerVerdict::inconclusive : SamplerVerdict::note,
                            fmt::format("coordinate {}: all {} values in {} sets lie on a grid of 1/{}", d,
                                        common.values.size(), sets, steps)};
    }
    return SamplerCheck{"values", SamplerVerdict::note,
                        fmt::format("coordinate {}: {} different values in {} sets of {} points; those of a set hardly "
                                    "ever occur in another where a randomisation has many outcomes",
                                    d, common.values.size(), sets, evidence.drawn.points)};
}

}  // namespace

std::vector<SamplerCheck> doubt_values(const StructureEvidence& evidence, const std::vector<Promise>& kept) {
    std::vector<SamplerCheck> doubts;
    std::vector<std::size_t> repeating;
    for (std::size_t d = 0; d < evidence.drawn.dimension; ++d)
        if (repeats_values(evidence, d)) repeating.push_back(d);
    const bool origins = !repeating.empty() && shares_origins(evidence, repeating);
    for (const std::size_t d : repeating) {
        const auto values = [d](const SetStructure& set) { return set.coordinates[d].values; };
        const auto [least, most] =
            std::minmax_element(evidence.sets.begin(), evidence.sets.end(),
                                [&](const auto& a, const auto& b) { return values(a) < values(b); });
        const char* const why = origins             ? ", as where consecutive points share an origin"
                                : has_lattice(kept) ? ", as in the lattice that is promised"
                                : is_grid(evidence, kept, values(*least)) && is_grid(evidence, kept, values(*most))
                                    ? ", as in a grid of the cells that are promised"
                                    : nullptr;
        doubts.push_back({"values", why ? SamplerVerdict::note : SamplerVerdict::inconclusive,
                          fmt::format("coordinate {}: as few as {} values in {} points{}", d, values(*least),
                                      evidence.drawn.points, why ? why : "; chance would let nearly all differ")});
    }
    if (!evidence.randomised) return doubts;
    for (std::size_t d = 0; d < evidence.drawn.dimension; ++d) {
        if (auto doubt = doubt_grid(evidence, kept, d)) doubts.push_back(std::move(*doubt));
    }
    return doubts;
}

}  // namespace ff::studies
