#pragma once

#include "studies/spec/spec.hpp"

#include <cstdint>

namespace ff::studies {

inline constexpr std::uint64_t max_trials = 1ULL << 32;  ///< a stream addresses trials with 32 bits

/// Sets the number of trials; sizes with a number of their own keep their share of it, at least 2.
/// @throws UserError  if there are fewer than 2, more than `max_trials`, or fewer than a pilot needs
void set_trials(StudySpec& spec, std::uint64_t trials);

}  // namespace ff::studies
