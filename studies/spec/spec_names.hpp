#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace ff::studies {

/// Names in study files for the choices of a method or a study, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> completion_names{"direct", "reciprocal"};
inline constexpr std::array<std::string_view, 2> allocation_names{"patch", "face"};
inline constexpr std::array<std::string_view, 2> map_names{"uniform", "graded"};
inline constexpr std::array<std::string_view, 4> tracer_names{"automatic", "box", "embree", "leaky"};
inline constexpr std::array<std::string_view, 2> inapplicable_names{"refuse", "skip"};
inline constexpr std::size_t sound_tracers = 3;  // the others are controls: known, not suggested

}  // namespace ff::studies
