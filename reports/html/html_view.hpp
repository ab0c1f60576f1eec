#pragma once

#include "reports/text/table.hpp"
#include "reports/words/headline.hpp"
#include "studies/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace ff::reports {

/// A list of `text`.
nlohmann::ordered_json texts_view(const std::vector<std::string>& lines);

/// The view of a headline for templates: `verdict`, `numbers` (`value`, `label`, `detail`).
nlohmann::ordered_json headline_view(const Headline& headline);

/// The view of a table for table.mustache: `id`, `title`, `note`, `groups` (`title`, `span`), `columns` (`title`,
/// `number`), `rows` of a `name` and `cells` (`text`, `number`, `mark`, `says`: the mark in words), `remarks`.
nlohmann::ordered_json table_view(const Table& table);

/// How to reproduce the page: `study_file` (its text), `file` and `tables_file` (names), `program` that made it.
nlohmann::ordered_json reproduction_view(const studies::StudyResults& results);

}  // namespace ff::reports
