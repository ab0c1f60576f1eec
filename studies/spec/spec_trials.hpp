#pragma once

#include "studies/spec/spec.hpp"

#include <cstdint>
#include <string>

namespace ff::studies {

inline constexpr std::uint64_t max_trials = 1ULL << 32;  ///< a stream addresses trials with 32 bits

/// Why a cell cannot have that many trials: "(why). Suggestion."; empty where it can.
std::string problem_with_trials(std::uint64_t trials);

/// Sets the number of trials; sizes with a number of their own keep their share of it, at least 2.
/// @throws UserError  if there are fewer than 2, more than `max_trials`, or fewer than a pilot needs
void set_trials(StudySpec& spec, std::uint64_t trials);

}  // namespace ff::studies
