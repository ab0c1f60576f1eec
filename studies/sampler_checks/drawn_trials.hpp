#pragma once

#include "core/points/points.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Functions on the unit cube with integral 1, not below 0: a smooth one; a step at an oblique plane; steps across the
/// axes.
inline constexpr std::array<std::string_view, 3> integrand_names{"a smooth function", "a step along a slanting plane",
                                                                 "steps across the axes"};

/// Numbers of wide slices. Multiples of a step that is nearly a fraction leave some of them uneven, never all.
inline constexpr std::array<std::uint64_t, 4> wide_slices{2, 3, 5, 7};

/// How evenly one coordinate fills slices of [0, 1), averaged over trials.
struct SliceCounts {
    double shared = 0;  ///< pairs of points in one of n slices; (n - 1) / 2 of independent points
    /// Variance of the number of points in a wide slice, in units of that of independent points.
    std::array<double, wide_slices.size()> variance{};
};

inline constexpr std::uint64_t most_for_slices = 1u << 16;

/// The data that the checks need from every trial.
struct DrawnTrials {
    std::vector<std::array<std::uint32_t, max_dimension>> picked;   ///< a point picked at random from each set
    std::array<std::vector<double>, integrand_names.size()> means;  ///< [function]: its mean over each set
    std::array<double, integrand_names.size()> largest{};           ///< [function]: its largest value
    std::vector<std::uint64_t> fingerprints;  ///< fingerprints of the sets, independent of the order of points
    std::vector<SliceCounts> slices;          ///< one for each coordinate; empty for more than `most_for_slices` points
};

DrawnTrials draw_trials(const PointSource& source, std::size_t dimension, StreamKey key, std::uint64_t trials);

}  // namespace ff::studies
