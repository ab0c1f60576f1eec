#pragma once

#include "reports/text/json_values.hpp"
#include "reports/text/table.hpp"
#include "reports/words/headline.hpp"
#include "studies/results/results.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A content-security policy for a document that needs nothing but what it contains: these styles and scripts, known by
/// their SHA-256, run; nothing is loaded, nothing else runs, no text is evaluated as code.
std::string security_policy(std::span<const std::string_view> styles, std::span<const std::string_view> scripts);

/// A list of `text`.
Json texts_view(const std::vector<std::string>& lines);

/// The view of a headline for templates: `verdict`, `numbers` (`value`, `label`, `detail`).
Json headline_view(const Headline& headline);

/// The view of a table for table.mustache: `id`, `title`, `note`, `inside` (its size and columns), `groups` (`title`,
/// `span`), `columns` (`title`, `number`), `rows` of a `name` and `cells` (`text`, `number`, `mark`, `says`: the mark
/// in words), `remarks`.
Json table_view(const Table& table);

/// How to reproduce the page: `study_file` (its text), `file` and `tables_file` (names), `program` that made it.
Json reproduction_view(const studies::StudyResults& results);

}  // namespace ff::reports
