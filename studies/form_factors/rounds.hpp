#pragma once

#include "studies/form_factors/form_factors.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies {

/// A pair gets at most so many rounds whose interval may be reported.
inline constexpr std::size_t most_rounds = 3;

/// Level of the interval of such a round, the first being 0. The rounds share the error rate alpha, so that it does not
/// matter which of them is reported, or why: nine tenths for the first, which seldom misses, a twentieth for each
/// other.
double round_level(double alpha, std::size_t round);

/// What sampling found for a pair of faces.
struct PairEstimate {
    std::optional<SampledSum> sum;  ///< of the exchange area; empty where no round was completed, or none was needed
    bool by_points = false;
    double level = 0;           ///< of its interval
    std::uint64_t samples = 0;  ///< behind it
    bool contradicted = false;
    Estimate other;  ///< of the independent randomisation that contradicts
};

struct SamplingOutcome {
    std::vector<PairEstimate> estimates;  ///< as FacePairs::pairs
    std::uint64_t samples = 0;
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;
    bool interrupted = false;
};

/// Samples what geometry leaves open. Pilot rounds decide on points or rays for each pair and on sizes; rounds with
/// randomisations of their own, most_rounds at most, give the estimates. Every estimate is compared with those of other
/// rounds, by other rays or points.
/// @param alpha  1 - level of a pair's interval
SamplingOutcome sample_pairs(const Scene& scene, const FacePairs& geometry, const FormFactorRequest& request,
                             double alpha, bool rays_are_exact_enough);

}  // namespace ff::studies
