#pragma once

#include "samplers/sampler.hpp"
#include "studies/sampler_checks/structure_checks.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// The subject of a check, and both risks of all statistical checks together.
struct SamplerCheckRequest {
    std::uint64_t points = 0;
    std::size_t dimension = max_dimension;
    std::uint64_t trials = 0;  ///< 0: as many as take about a second, limited to those available
    std::uint64_t seed = 1;
    std::vector<Promise> promises{};  ///< what every set has, according to the author; empty: structure is searched for
    double alpha = 1e-3;              ///< risk of rejecting a sound sampler, over all statistical checks (Holm)
    double power = 0.99;              ///< probability of detecting, in one check, the effect that must not be missed
};

struct SamplerChecks {
    std::uint64_t trials = 0;
    std::uint64_t sets = 0;  ///< number of sets, those of the first trials, whose structure was looked at
    std::vector<SamplerCheck> checks;
    std::vector<std::string> not_asked;  ///< checks left out, with the reason
};

/// Checks any sampler against the contract of the catalogue: the same bits from any first point, points in [0, 1), a
/// stratified axis where the sizes promise one; for a randomised one also uniform coordinates, and uniform pairs of
/// them, in a randomly picked point, unbiased means of known integrals, and trials without serial correlation. A
/// promise is kept where every set that is examined keeps it; without promises, notes say what the sets look like, and
/// a set that nearly has a structure is inconclusive (see structure_checks.hpp).
/// @throws UserError where the size is impossible, points have weights, or sets of the size cannot keep a promise
SamplerChecks check_sampler(const samplers::CatalogueEntry& sampler, const SamplerCheckRequest& request);

}  // namespace ff::studies
