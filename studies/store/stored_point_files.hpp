#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

/// Keeps the files of points that a study names, so that reports and merging need only the store.
void write_point_files(Database& database, const StudySpec& spec);

/// Adds the samplers that a stored study names. @throws UserError where what was kept is damaged
void restore_point_files(const Database& database);

}  // namespace ff::studies
