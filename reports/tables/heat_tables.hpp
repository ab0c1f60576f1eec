#pragma once

#include "reports/text/table.hpp"
#include "reports/words/heat_words.hpp"

#include <cstddef>
#include <optional>

namespace ff::reports {

/// A row for each group of faces, of every case. Empty where it would repeat the table of faces: there is one case, the
/// materials file names no groups, and no group of several faces exchanges power.
std::optional<Table> groups_table(const HeatReport& report);

/// A row for each face; with more than `most` faces, those with the largest powers, as a remark says.
Table flows_table(const HeatReport& report, const studies::heat::SolvedCase& solved, std::size_t most);

}  // namespace ff::reports
