#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

// Outside code and files that a study uses, kept so that reports and merging need only the store.

/// Stores the files of points that a study names, and the declarations of its other outside samplers.
void write_added_samplers(Database& database, const StudySpec& spec);

/// Adds the samplers that a stored study names. @throws UserError where the stored data are damaged
void restore_added_samplers(const Database& database);

/// Stores the declarations of a study's outside estimators.
void write_added_estimators(Database& database, const StudySpec& spec);

/// Adds the estimators that a stored study names; existing ones stay.
void restore_added_estimators(const Database& database);

}  // namespace ff::studies
