#pragma once

#include "core/points/stream.hpp"

#include <cstdint>
#include <optional>

namespace ff::app {

/// Options that several commands take, checked.
/// @throws UserError

/// The seed of --seed.
Seed checked_seed(std::uint64_t seed);

/// A fresh seed.
Seed fresh_seed();

/// Threads of --threads; all cores by default.
unsigned thread_count(const std::optional<unsigned>& threads);

}  // namespace ff::app
