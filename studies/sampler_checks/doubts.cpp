#include "samplers/point_sets/net_parameter.hpp"
#include "samplers/support/sizes.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/sampler_checks/point_groups.hpp"
#include "studies/sampler_checks/structure_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

constexpr std::uint64_t least_points = 32;  // with fewer, sound samplers fill slices partly
constexpr std::uint64_t misfits = 4;        // slices without one point that one or two wrong points leave
constexpr std::uint64_t near_a_power = 8;   // sequences nearly fill as many slices at these sizes
constexpr std::uint64_t least_for_shift = 5;

/// Whether sets of this size that nearly fill n slices cannot be the first points of a sound sequence. At a power of
/// two those in base 2 fill all; at other sizes none fills nearly all, unless a power of its base is near.
bool is_telling_size(std::uint64_t n, std::size_t dimension) {
    if (n < least_points) return false;
    if (std::has_single_bit(n)) return dimension > 1 || n > least_points;
    // In one dimension sequences of the golden ratio nearly fill any Fibonacci number of slices.
    if (dimension == 1) return false;
    for (const std::uint64_t base : {2u, 3u, 5u, 7u, 11u, 13u}) {
        for (std::uint64_t power = base; power <= n + near_a_power; power *= base) {
            if (power + near_a_power >= n && power != n) return false;
        }
    }
    return true;
}

/// Every coordinate has one point in each slice, or in all but a few. The chance that n >= 32 independent points have
/// at most 4 slices without one point is below 1e-7 in one coordinate of one set.
std::optional<SamplerCheck> nearly_latin(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    if (!is_telling_size(n, evidence.drawn.dimension)) return std::nullopt;
    std::uint64_t worst = n;
    std::size_t coordinate = 0;
    std::uint64_t broken = 0;
    for (const SetStructure& set : evidence.sets) {
        bool whole = true;
        for (std::size_t d = 0; d < set.coordinates.size(); ++d) {
            const std::uint64_t singles = set.coordinates[d].single_slices;
            whole &= singles == n;
            if (singles >= worst) continue;
            worst = singles;
            coordinate = d;
        }
        broken += whole ? 0 : 1;
    }
    if (worst == n || worst + misfits < n) return std::nullopt;
    return SamplerCheck{
        "nearly a Latin hypercube", evidence.randomised ? SamplerVerdict::inconclusive : SamplerVerdict::note,
        fmt::format("{} of {} slices of coordinate {} have one point; {} of {} sets are none. Is a point "
                    "missing, such as the first of a net?",
                    worst, n, coordinate, broken, evidence.sets.size())};
}

/// Finds that in every set a shift modulo 1 would make all coordinates fill their slices, but some do not. For
/// independent points the probability of this is below n! / n^(n - 1), 1e-11 for 32 points. At sizes that are not a
/// power of two it also holds for a lattice in base 2, such as one of 96 = 64 + 32 points.
std::optional<SamplerCheck> shifted_slices(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    if (!std::has_single_bit(n) || !is_telling_size(n, evidence.drawn.dimension)) return std::nullopt;
    std::uint64_t whole = 0;
    for (const SetStructure& set : evidence.sets) {
        const auto& coordinates = set.coordinates;
        if (!std::ranges::all_of(coordinates, [](const auto& one) { return one.fills_shifted; })) return std::nullopt;
        if (std::ranges::all_of(coordinates, [n](const auto& one) { return one.single_slices == n; })) ++whole;
    }
    if (whole == evidence.sets.size()) return std::nullopt;
    return SamplerCheck{"shifted slices", SamplerVerdict::inconclusive,
                        fmt::format("every coordinate has one point in each of {} slices, but these begin elsewhere "
                                    "than at 0 in {} of {} sets: a shift modulo 1 breaks nets and Latin hypercubes",
                                    n, evidence.sets.size() - whole, evidence.sets.size())};
}

/// Finds that in no set and coordinate two points share one of a few more than n slices: for independent points the
/// probability of that is below 1e-10 with 32 points and 36 slices.
std::optional<SamplerCheck> part_of_latin(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    if (!is_telling_size(n, evidence.drawn.dimension)) return std::nullopt;
    const std::uint64_t more = evidence.sets.front().coordinates.front().free_slices;
    const bool are_all_alike = std::ranges::all_of(evidence.sets, [&](const SetStructure& set) {
        return std::ranges::all_of(set.coordinates, [&](const CoordinateStructure& one) {
            return one.free_slices == more && one.single_slices < n;  // grids have a free slice more, too
        });
    });
    if (more == 0 || !are_all_alike) return std::nullopt;
    return SamplerCheck{
        "nearly a Latin hypercube", evidence.randomised ? SamplerVerdict::inconclusive : SamplerVerdict::note,
        fmt::format("no two points share one of {} slices of any coordinate, as in a Latin hypercube of {} points of "
                    "which {} left out",
                    n + more, n + more, more == 1 ? "1 was" : fmt::format("{} were", more))};
}

/// Two points share one of n slices less often than independent ones do, and numbers of points in wide slices vary
/// less, too. A set of which a part is stratified and the rest random has both in the same ratio. Where all points are
/// spread by one rule, some wide slices are filled far more evenly (in the catalogue, from 32 points on, 0.6 of the
/// first ratio at most).
std::optional<SamplerCheck> partly_random(const StructureEvidence& evidence, std::size_t d) {
    const auto n = static_cast<double>(evidence.drawn.points);
    const auto trials = static_cast<double>(evidence.trials);
    const SliceCounts& counts = evidence.slices[d];
    const double fine = counts.shared / ((n - 1) / 2);
    const double z = (1 - fine) * std::sqrt(trials * n / 2);  // standard normal for independent points
    if (stats::normal_tail(z) > false_doubts / (3 * static_cast<double>(evidence.drawn.dimension))) return std::nullopt;
    if (fine > 0.9 || fine == 0) return std::nullopt;
    // Sequences vary by a point or so in either half, which is little, but may be as little as what is shared.
    if (counts.variance.front() * n / 4 < 2 && !std::has_single_bit(evidence.drawn.points)) return std::nullopt;
    for (std::size_t k = 0; k < wide_slices.size(); ++k) {
        const double standard_error = std::sqrt(2 / (static_cast<double>(wide_slices[k] - 1) * trials));
        if (counts.variance[k] * (1 - 3 * standard_error) < 0.75 * fine) return std::nullopt;
    }
    return SamplerCheck{
        "partly random", SamplerVerdict::inconclusive,
        fmt::format("coordinate {}: {:.3g} pairs of points share one of {} slices, of random points "
                    "{:.3g}, of a Latin hypercube 0, as if {:.0f} % of points were random",
                    d, counts.shared, evidence.drawn.points, (n - 1) / 2, 100 * (1 - std::sqrt(1 - fine)))};
}

/// Looks at every set: a shift that happens to be harmless for the digits of one is not a fault.
std::optional<SamplerCheck> shifted_net(const StructureEvidence& evidence) {
    if (evidence.drawn.sets < least_for_shift) return std::nullopt;
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    for (std::uint64_t set = 0; set < evidence.drawn.sets; ++set) {
        const auto net = net_before_shift(evidence.drawn, set);
        const auto& t = evidence.sets[set].t;
        if (!net || !t) return std::nullopt;
        before = std::max(before, samplers::net_parameter(*net, 0, 2).value_or(0));
        after = std::max(after, *t);
    }
    if (before >= after) return std::nullopt;
    return SamplerCheck{
        "shifted net", SamplerVerdict::inconclusive,
        fmt::format("points are a digital net of t {} in base 2, shifted modulo 1, which leaves t up to "
                    "{}. A digital shift keeps the net",
                    before, after)};
}

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
    return std::ranges::count(kept, Promise{PromiseKind::lattice}) > 0;
}

/// Whether this many values per coordinate are those of a regular grid with one point in each of its cells.
bool is_grid(const StructureEvidence& evidence, const std::vector<Promise>& kept, std::uint64_t values) {
    return std::ranges::count(kept, Promise{PromiseKind::stratified}) > 0 &&
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
    std::vector<std::pair<std::uint32_t, std::uint32_t>> values;  // each value with its set
    for (std::uint32_t set = 0; set < drawn.sets; ++set) {
        for (const std::uint32_t x : drawn.row(set, d)) values.emplace_back(x, set);
    }
    std::ranges::sort(values);
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
    found.sharing = static_cast<std::uint64_t>(std::ranges::count(in_common, true));
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

std::vector<SamplerCheck> doubt_structure(const StructureEvidence& evidence) {
    std::vector<SamplerCheck> doubts;
    const auto add = [&](std::optional<SamplerCheck> doubt) {
        if (doubt) doubts.push_back(std::move(*doubt));
    };
    add(nearly_latin(evidence));
    add(part_of_latin(evidence));
    if (!evidence.randomised) return doubts;
    add(shifted_slices(evidence));
    if (doubts.empty() && evidence.drawn.points >= least_points) {
        for (std::size_t d = 0; d < evidence.slices.size(); ++d) add(partly_random(evidence, d));
    }
    if (evidence.base == 2) add(shifted_net(evidence));
    return doubts;
}

std::vector<SamplerCheck> doubt_values(const StructureEvidence& evidence, const std::vector<Promise>& kept) {
    std::vector<SamplerCheck> doubts;
    std::vector<std::size_t> repeating;
    for (std::size_t d = 0; d < evidence.drawn.dimension; ++d)
        if (repeats_values(evidence, d)) repeating.push_back(d);
    const bool origins = !repeating.empty() && shares_origins(evidence, repeating);
    for (const std::size_t d : repeating) {
        const auto values = [d](const SetStructure& set) { return set.coordinates[d].values; };
        const auto [least, most] = std::ranges::minmax_element(evidence.sets, {}, values);
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
