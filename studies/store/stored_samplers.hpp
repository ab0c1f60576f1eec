#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

/// Stores the files of points that a study names, and the declarations of its other outside samplers, so that reports
/// and merging need only the store.
void write_added_samplers(Database& database, const StudySpec& spec);

/// Adds the samplers that a stored study names. @throws UserError where the stored data are damaged
void restore_added_samplers(const Database& database);

}  // namespace ff::studies
