#pragma once

#include "core/exact/pair_exchange.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// What sampling found for a pair of faces.
struct PairEstimate {
    std::optional<SampledSum> sum;  ///< the exchange area; empty where no round was completed, or none was needed
    ExchangeMethod method = ExchangeMethod::rays;  ///< cells, points or rays
    double level = 0;                              ///< confidence level of its interval
    std::uint64_t samples = 0;                     ///< rays or points behind it
    bool contradicted = false;
    EstimatedSum other;  ///< estimate from the independent randomisation that contradicts
};

/// What sampling found for the pairs of a row that are estimated from it, the smaller of their faces. It does not
/// depend on other rows, so that processes can share rows out, and a run can be resumed.
struct SampledRow {
    std::uint32_t row = 0;                                          ///< its face
    std::vector<std::pair<std::uint32_t, PairEstimate>> estimates;  ///< each with the pair's place in FacePairs::pairs
    std::uint64_t samples = 0;
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;  ///< rays that met nothing
};

/// The row as 64-bit words, for a file or another process of the same program.
std::vector<std::uint64_t> to_words(const SampledRow& row);

/// The row from which `to_words` made these; empty where they are not from it.
std::optional<SampledRow> sampled_row(std::span<const std::uint64_t> words);

}  // namespace ff::studies::form_factors
