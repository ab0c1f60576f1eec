#include "studies/sampler_checks/structure_checks.hpp"

#include "samplers/point_sets/draw_set.hpp"
#include "samplers/point_sets/net_parameter.hpp"
#include "samplers/support/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

constexpr std::uint64_t most_sets = 100;
constexpr std::uint64_t usual_points = 1u << 19;  // points of all drawn sets together

/// Slices, of n, that hold one of n independent points, on average.
double random_singles(std::uint64_t n) {
    const auto points = static_cast<double>(n);
    return points * std::pow(1 - 1 / points, points - 1);
}

/// "3", or "3 to 5", over all sets.
std::string range(const StructureEvidence& evidence, const std::function<std::uint64_t(const SetStructure&)>& value) {
    const auto [first, last] = std::ranges::minmax_element(evidence.sets, {}, value);
    const std::uint64_t least = value(*first);
    const std::uint64_t most = value(*last);
    return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

/// "3 of coordinate 0, 4 to 5 of coordinate 1", or "4 of every coordinate".
std::string by_coordinate(const StructureEvidence& evidence,
                          const std::function<std::uint64_t(const CoordinateStructure&)>& value) {
    std::vector<std::string> ranges;
    for (std::size_t d = 0; d < evidence.drawn.dimension; ++d)
        ranges.push_back(range(evidence, [&](const SetStructure& set) { return value(set.coordinates[d]); }));
    if (std::ranges::count(ranges, ranges.front()) == static_cast<std::ptrdiff_t>(ranges.size()))
        return ranges.front() + " of every coordinate";
    std::string text;
    for (std::size_t d = 0; d < ranges.size(); ++d)
        text += fmt::format("{}{} of coordinate {}", d == 0 ? "" : ", ", ranges[d], d);
    return text;
}

SamplerCheck describe_values(const StructureEvidence& evidence) {
    return {"distinct values", SamplerVerdict::note,
            fmt::format("{}, in {} points",
                        by_coordinate(evidence, [](const CoordinateStructure& one) { return one.values; }),
                        evidence.drawn.points)};
}

SamplerCheck describe_slices(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    return {fmt::format("slices of 1/{} with one point", n), SamplerVerdict::note,
            fmt::format("{}; random points: {:.0f}",
                        by_coordinate(evidence, [](const CoordinateStructure& one) { return one.single_slices; }),
                        random_singles(n))};
}

SamplerCheck describe_cells(const StructureEvidence& evidence) {
    const std::uint64_t n = evidence.drawn.points;
    return {
        fmt::format("cells of {} a side with one point", evidence.sets.front().cells_a_side), SamplerVerdict::note,
        fmt::format("{} of {}; random points: {:.0f}",
                    range(evidence, [](const SetStructure& set) { return set.single_cells; }), n, random_singles(n))};
}

/// The t-value of our own net with this size, where there is one.
std::optional<std::uint32_t> t_of_house(const StructureEvidence& evidence) {
    const auto& house = samplers::house_sampler();
    if (house.info.base != evidence.base) return std::nullopt;
    const auto set = samplers::draw_set(house, {evidence.drawn.points, evidence.drawn.dimension});
    return samplers::net_parameter(set, 0, evidence.base);
}

SamplerCheck describe_net(const StructureEvidence& evidence) {
    std::string found = fmt::format("t in base {} is {} (0 is best, {} no structure", evidence.base,
                                    range(evidence, [](const SetStructure& set) { return set.t.value_or(0); }),
                                    samplers::count_digits(evidence.drawn.points, evidence.base));
    if (const auto house = t_of_house(evidence))
        found += fmt::format("; {} has {}", samplers::house_sampler().info.name, *house);
    found += ")";
    const auto& pairs = evidence.sets.front().pairs;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        found += fmt::format("{}{} and {}: {}", i == 0 ? "; of coordinates " : ", ", pairs[i].first, pairs[i].second,
                             range(evidence, [&](const SetStructure& set) { return set.pairs[i].t; }));
    }
    return {"net", SamplerVerdict::note, found};
}

}  // namespace

StructureEvidence draw_structure(const PointSource& source, std::size_t dimension, StreamKey key, std::uint64_t trials,
                                 std::uint32_t base) {
    StructureEvidence evidence;
    evidence.base = base;
    evidence.randomised = source.randomised();
    evidence.trials = trials;
    const std::uint64_t n = source.points();
    const std::uint64_t affordable = std::clamp<std::uint64_t>(usual_points / n, 2, most_sets);
    const std::uint64_t sets = evidence.randomised ? std::min(trials, affordable) : 1;
    evidence.drawn = {n, dimension, sets, {}};
    evidence.drawn.coordinate.reserve(sets * dimension * n);
    for (std::uint32_t set = 0; set < sets; ++set) {
        const auto drawn = samplers::coordinates_of_set(source, dimension, {.key = key, .trial = set});
        evidence.drawn.coordinate.insert(evidence.drawn.coordinate.end(), drawn.begin(), drawn.end());
    }
    for (std::uint64_t set = 0; set < sets; ++set) evidence.sets.push_back(structure_of(evidence.drawn, set, base));
    return evidence;
}

std::vector<SamplerCheck> describe(const StructureEvidence& evidence) {
    const SetStructure& first = evidence.sets.front();
    std::vector<SamplerCheck> notes{describe_values(evidence), describe_slices(evidence)};
    if (first.cells_a_side != 0) notes.push_back(describe_cells(evidence));
    if (first.t && evidence.drawn.points > 1) notes.push_back(describe_net(evidence));
    const auto lattices = std::ranges::count_if(evidence.sets, [](const SetStructure& set) { return set.lattice; });
    if (lattices > 0 && evidence.drawn.points > 2)
        notes.push_back({"lattices", SamplerVerdict::note,
                         fmt::format("{} of {} sets are one, shifted or not", lattices, evidence.sets.size())});
    return notes;
}

SamplerCheck check_repeated_sets(std::span<const std::uint64_t> fingerprints) {
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> trials_of;
    for (std::size_t trial = 0; trial < fingerprints.size(); ++trial) trials_of[fingerprints[trial]].push_back(trial);

    // The k trials of a set that comes back are any k of all T; the first two are a given distance apart with a
    // probability of at most k / T.
    const auto count = static_cast<double>(fingerprints.size());
    double expected = 0;
    std::unordered_map<std::size_t, std::size_t> sets_by_distance;
    for (const auto& [set, trials] : trials_of) {
        if (trials.size() < 2) continue;
        expected += static_cast<double>(trials.size()) / count;
        ++sets_by_distance[trials[1] - trials[0]];
    }
    const std::string name = "sets differ";
    if (sets_by_distance.empty()) return {name, SamplerVerdict::pass, "no set is repeated"};

    const auto [distance, sets] = *std::ranges::max_element(sets_by_distance, [](const auto& a, const auto& b) {
        return std::pair(a.second, b.first) < std::pair(b.second, a.first);
    });
    // Chernoff's bound of so many at one distance, times the number of distances.
    const auto found = static_cast<double>(sets);
    const double p = found <= expected ? 1 : count * std::exp(found - expected) * std::pow(expected / found, found);
    if (p > risk_of_repeats)
        return {name, SamplerVerdict::pass,
                fmt::format("{} different sets in {} trials, which come back as chance has it", trials_of.size(),
                            fingerprints.size())};
    return {name, SamplerVerdict::fail,
            fmt::format("{} sets come back after {} trials (p < {:g}): trials are not independent", sets, distance,
                        risk_of_repeats)};
}

}  // namespace ff::studies
