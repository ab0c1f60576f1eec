#pragma once

#include "studies/plan/plan.hpp"
#include "studies/store/records.hpp"
#include "studies/store/sqlite.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace ff::studies {

/// The unit that a trial belongs to; units are in the order of cells and trials. Empty where there is none.
std::optional<std::size_t> unit_of(const StudyPlan& plan, std::size_t cell, std::uint64_t trial);

/// The checksum saved with a unit, to notice changes of its rows.
std::int64_t checksum(const WorkUnit& unit, const UnitRecord& record);

enum class Checksums { saved, none };

/// @throws IoError unless every saved unit is one of the plan, with sums of all its patches or none, every row of an
/// observation belongs to a saved unit, numbers of rays make sense, and all of it has the checksum that was saved
void expect_rows_of_plan(const Database& database, const std::filesystem::path& file, const StudyPlan& plan,
                         Checksums checksums);

/// Saves missing checksums, computed from the present rows.
void add_checksums(const Database& database, const std::filesystem::path& file, const StudyPlan& plan);

}  // namespace ff::studies
