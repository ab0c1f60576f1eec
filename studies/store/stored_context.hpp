#pragma once

#include "studies/store/sqlite.hpp"
#include "studies/store/store.hpp"

#include <filesystem>

namespace ff::studies {

/// The table `context` of a store, with a checksum of its own: the promise of repeatability does not cover it.

/// Replaces it as a whole; part of the caller's transaction.
void write_context(const Database& database, const Context& context);

Context read_context(const Database& database);

/// @throws IoError where it has changed since it was saved
void expect_sound_context(const Database& database, const std::filesystem::path& file);

}  // namespace ff::studies
