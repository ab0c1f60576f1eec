#pragma once

#include "studies/sampler_checks/sampler_verdict.hpp"

#include <cstdint>
#include <span>

namespace ff::studies {

/// Probability that independent trials fail the check below.
inline constexpr double risk_of_repeats = 1e-6;

/// Whether sets come back after a fixed number of trials, as those of a generator that is started again do. Sets that
/// come back at different distances are no fault: a sampler may have only a few.
/// @param fingerprints  of the sets of all trials, whatever the order of their points
SamplerCheck check_repeated_sets(std::span<const std::uint64_t> fingerprints);

}  // namespace ff::studies
