#pragma once

#include "core/points/stream.hpp"

#include <cstdint>
#include <optional>

namespace ff::app {

/// Options that several commands take, checked.
/// @throws UserError

/// The seed of --seed.
Seed checked_seed(std::uint64_t seed);

/// A seed that nobody has seen before.
Seed fresh_seed();

/// Threads of --threads; all cores where it is not given.
unsigned thread_count(const std::optional<unsigned>& threads);

}  // namespace ff::app
