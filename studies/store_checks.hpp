#pragma once

#include "studies/plan.hpp"
#include "studies/sqlite.hpp"

#include <filesystem>

namespace ff::studies {

/// @throws IoError unless every saved unit is one of the plan, with sums of all its patches or none, and every row of
/// an observation belongs to a saved unit
void expect_rows_of_plan(const Database& database, const std::filesystem::path& file, const StudyPlan& plan);

}  // namespace ff::studies
