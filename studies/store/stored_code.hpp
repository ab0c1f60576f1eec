#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

// Outside code and files that a study uses, kept so that reports and merging need only the store.

/// Stores the files of points that a study names, and the declarations of its other outside samplers and estimators.
void write_outside_code(Database& database, const StudySpec& spec);

/// Adds the samplers and estimators that a stored study names; existing ones stay. @throws UserError where the stored
/// data are damaged
void restore_outside_code(const Database& database);

}  // namespace ff::studies
