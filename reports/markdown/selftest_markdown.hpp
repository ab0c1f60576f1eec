#pragma once

#include "studies/form_factors/coverage.hpp"
#include "studies/selftest/selftest.hpp"

#include <string>

namespace ff::reports {

/// The tables of docs/validation.md, in Markdown.
std::string selftest_markdown(const studies::Selftest& selftest);

/// Measured rates beside what is claimed of them, a row each, under the table's title.
std::string rate_table_markdown(const studies::RateTable& table, double level);

/// What `ffstudy form_factors_selftest` prints.
std::string form_factor_coverage_markdown(const studies::FormFactorCoverage& coverage);

}  // namespace ff::reports
