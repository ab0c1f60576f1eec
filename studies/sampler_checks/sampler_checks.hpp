#pragma once

#include "samplers/sampler.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

enum class SamplerVerdict { pass, fail, inconclusive };

/// One requirement on a sampler.
struct SamplerCheck {
    std::string name;
    SamplerVerdict verdict = SamplerVerdict::pass;
    std::string found;
};

/// What to check, and both risks of all statistical checks together.
struct SamplerCheckRequest {
    std::uint64_t points = 0;
    std::size_t dimension = max_dimension;
    std::uint64_t trials = 0;  ///< 0: as many as `usual_trials` says
    std::uint64_t seed = 1;
    double alpha = 1e-3;  ///< of rejecting a sound sampler, over all statistical checks (Holm)
    double power = 0.99;  ///< of detecting, in one check, the effect that must not be missed
};

struct SamplerChecks {
    std::uint64_t trials = 0;
    std::vector<SamplerCheck> checks;
    std::vector<std::string> not_asked;  ///< checks left out, with the reason
};

/// Trials that take about a second, limited to those available.
std::uint64_t usual_trials(const samplers::SamplerInfo& info, std::uint64_t points);

/// Checks any sampler against the contract of the catalogue: the same bits from any first point, points in [0, 1), a
/// stratified axis where its sizes promise it; for a randomised one also uniform coordinates, and uniform pairs of
/// them, in a randomly picked point, unbiased means of known integrals, and trials without serial correlation.
/// @throws UserError where the size is impossible, or points have weights
SamplerChecks check_sampler(const samplers::CatalogueEntry& sampler, const SamplerCheckRequest& request);

}  // namespace ff::studies
