#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

/// Stores the declarations of a study's outside estimators, so that reports and merging need only the store.
void write_added_estimators(Database& database, const StudySpec& spec);

/// Adds the estimators that a stored study names; existing ones stay.
void restore_added_estimators(const Database& database);

}  // namespace ff::studies
