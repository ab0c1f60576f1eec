#include "samplers/point_sets/net_parameter.hpp"
#include "samplers/support/sizes.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/sampler_checks/point_groups.hpp"
#include "studies/sampler_checks/structure_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace ff::studies {
namespace {

constexpr std::uint64_t least_points = 32;  // of fewer, sound samplers fill slices partly
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

/// In every set a shift modulo 1 would make every coordinate fill its slices, and without it some do not. For
/// independent points the probability of this is below n! / n^(n - 1), 1e-11 for 32 points. At sizes that are not a
/// power of two it also holds for a lattice in base 2, such as one of 96 = 64 + 32 points.
std::optional<SamplerCheck> shifted_slices(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    if (!std::has_single_bit(n) || !is_telling_size(n, evidence.drawn.dimension)) return std::nullopt;
    std::uint64_t whole = 0;
    for (const SetStructure& set : evidence.sets) {
        const auto& coordinates = set.coordinates;
        if (!std::all_of(coordinates.begin(), coordinates.end(), [](const auto& one) { return one.fills_shifted; }))
            return std::nullopt;
        if (std::all_of(coordinates.begin(), coordinates.end(),
                        [n](const auto& one) { return one.single_slices == n; }))
            ++whole;
    }
    if (whole == evidence.sets.size()) return std::nullopt;
    return SamplerCheck{"shifted slices", SamplerVerdict::inconclusive,
                        fmt::format("every coordinate has one point in each of {} slices, but these begin elsewhere "
                                    "than at 0 in {} of {} sets: a shift modulo 1 breaks nets and Latin hypercubes",
                                    n, evidence.sets.size() - whole, evidence.sets.size())};
}

/// In every set no two points share one of a few more than n slices, in any coordinate: for independent points the
/// probability of that is below 1e-10 with 32 points and 36 slices.
std::optional<SamplerCheck> part_of_latin(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    if (!is_telling_size(n, evidence.drawn.dimension)) return std::nullopt;
    const std::uint64_t more = evidence.sets.front().coordinates.front().free_slices;
    const bool are_all_alike = std::all_of(evidence.sets.begin(), evidence.sets.end(), [&](const SetStructure& set) {
        return std::all_of(set.coordinates.begin(), set.coordinates.end(), [&](const CoordinateStructure& one) {
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
    const double z = (1 - fine) * std::sqrt(trials * n / 2);  // of independent points, standard normal
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

/// In every set: a shift that happens to be harmless for the digits of one is not a fault.
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

}  // namespace ff::studies
