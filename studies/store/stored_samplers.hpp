#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

/// Keeps the files of points that a study names, and of its other samplers from outside what they declare, so that
/// reports and merging need only the store.
void write_added_samplers(Database& database, const StudySpec& spec);

/// Adds the samplers that a stored study names. @throws UserError where what was kept is damaged
void restore_added_samplers(const Database& database);

}  // namespace ff::studies
