#pragma once

#include "studies/audit/printed_number.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies::audit {

/// Share of the published figures that are taken to be misprinted.
inline constexpr double misprint_share = 0.02;

/// Odds from which the audit contradicts what a publication says.
inline constexpr double refuting_odds = 1e4;

/// Whole numbers from `low` to `high`.
struct HitRange {
    std::int64_t low = 0;
    std::int64_t high = 0;

    [[nodiscard]] std::int64_t count() const { return high - low + 1; }
};

/// The whole numbers h with h / rays in `values`; empty where there is none. @pre rays >= 1
std::optional<HitRange> possible_hits(Range values, std::uint64_t rays);

/// A printed figure that is a number of hits divided by a known number of rays.
struct SampledFigure {
    PrintedNumber number;
    std::uint64_t rays = 1;
};

/// How well a number format explains figures that are hits over rays.
struct FormatEvidence {
    NumberFormat format;
    std::size_t figures = 0;    ///< informative figures: there are fewer numbers of hits than prints
    std::size_t whole = 0;      ///< those among them that are a whole number of hits in this format
    double expected = 0;        ///< expected number of whole ones if the figures were not fractions of the rays
    double chance = 1;          ///< probability of `whole` or more by chance
    double log_likelihood = 0;  ///< natural; of all figures, one in fifty being misprinted
};

/// Evidence for one format. @pre rays >= 1 in all figures
FormatEvidence weigh_format(std::span<const SampledFigure> figures, NumberFormat format);

/// Rounded and truncated, each to `digits` decimals and to `digits` significant digits; the likeliest first, decimals
/// where nothing tells.
std::vector<FormatEvidence> weigh_formats(std::span<const SampledFigure> figures, int digits);

}  // namespace ff::studies::audit
