#pragma once

#include "core/points/points.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Functions on the unit cube with integral 1: a smooth one; a step at an oblique plane; steps across the axes.
inline constexpr std::array<std::string_view, 3> integrand_names{"a smooth function", "a step along a slanting plane",
                                                                 "steps across the axes"};

/// What the checks need from every trial.
struct DrawnTrials {
    std::vector<std::array<std::uint32_t, max_dimension>> picked;   ///< a point picked at random from each set
    std::array<std::vector<double>, integrand_names.size()> means;  ///< of each function over each set
};

DrawnTrials draw_trials(const PointSource& source, std::size_t dimension, StreamKey key, std::uint64_t trials);

}  // namespace ff::studies
