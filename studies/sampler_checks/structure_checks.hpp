#pragma once

#include "studies/sampler_checks/drawn_trials.hpp"
#include "studies/sampler_checks/promises.hpp"
#include "studies/sampler_checks/structure.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ff::studies {

enum class SamplerVerdict { pass, fail, inconclusive, note };

/// One requirement on a sampler, or one thing that its points show.
struct SamplerCheck {
    std::string name;
    SamplerVerdict verdict = SamplerVerdict::pass;
    std::string found;
};

/// Whole sets of a sampler, and what was counted over all trials.
struct StructureEvidence {
    samplers::PointSet drawn;         ///< the points of one set at least
    std::vector<SetStructure> sets;   ///< structure of each drawn set
    std::uint32_t base = 2;           ///< base in which t-values are computed
    bool randomised = true;           ///< sets are independent
    std::vector<SliceCounts> slices;  ///< counts over all trials, one a coordinate; empty where nothing was counted
    std::uint64_t trials = 0;
};

/// Upper bound of the probability that independent random points raise any of the doubts below.
inline constexpr double false_doubts = 1e-6;

/// Looks at as many of the first trials as take about a second. @pre trials >= 1
StructureEvidence draw_structure(const PointSource& source, std::size_t dimension, StreamKey key, std::uint64_t trials,
                                 std::uint32_t base);

/// Describes the sets in comparison with random points: only notes.
std::vector<SamplerCheck> describe(const StructureEvidence& evidence);

/// Too few different values: inconclusive where neither chance nor origins that consecutive points share explain them,
/// and where all values of a randomised sampler lie on a grid of 2^16 steps or fewer, like numbers with few bits or
/// decimals. A note where consecutive points share origins, where a lattice or a grid of cells explains the values, and
/// where sets have values in common otherwise.
/// @param kept  promises that every set keeps
std::vector<SamplerCheck> doubt_values(const StructureEvidence& evidence, const std::vector<Promise>& kept);

/// Sets of a randomised sampler that are nearly a Latin hypercube, partly one, or one or a net that a shift modulo 1
/// has broken: inconclusive. A note where the sampler is not randomised and its set is nearly a Latin hypercube.
std::vector<SamplerCheck> doubt_structure(const StructureEvidence& evidence);

/// Probability that independent trials fail the check below.
inline constexpr double risk_of_repeats = 1e-6;

/// Whether sets recur after a fixed number of trials, like those of a generator that is restarted. Sets that recur at
/// different distances are not a fault: a sampler may have only a few.
/// @param fingerprints  of the sets of all trials, whatever the order of their points
SamplerCheck check_repeated_sets(std::span<const std::uint64_t> fingerprints);

}  // namespace ff::studies
