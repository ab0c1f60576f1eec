#pragma once

#include "reports/templates/templates.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::test {

/// A study with a method of every kind: rays with both completions, kernel values of infinite variance, quadrature, the
/// closed form; two scenes; names that CSV has to quote.
const studies::Store& small_store();
const studies::StudyResults& small_results();

/// The paper's tables beside a small study of its methods.
const studies::StudyResults& published_results();

/// The templates that come with the program.
const reports::Templates& shipped_templates();

/// Cells of a line of CSV (RFC 4180), quotes taken off.
std::vector<std::string> csv_fields(std::string_view line);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace ff::test
