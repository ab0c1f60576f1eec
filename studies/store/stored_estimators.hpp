#pragma once

#include "studies/spec/spec.hpp"
#include "studies/store/sqlite.hpp"

namespace ff::studies {

/// Keeps what a study's estimators from outside declare, so that reports and merging need only the store.
void write_added_estimators(Database& database, const StudySpec& spec);

/// Adds the estimators that a stored study names; one that is there already stays.
void restore_added_estimators(const Database& database);

}  // namespace ff::studies
