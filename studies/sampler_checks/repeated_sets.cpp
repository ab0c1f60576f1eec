#include "studies/sampler_checks/structure_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::studies {

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
    if (sets_by_distance.empty()) return {name, SamplerVerdict::pass, "no set comes back"};

    const auto [distance, sets] = *std::max_element(
        sets_by_distance.begin(), sets_by_distance.end(),
        [](const auto& a, const auto& b) { return std::pair(a.second, b.first) < std::pair(b.second, a.first); });
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
