#pragma once

#include "studies/form_factors/coverage.hpp"
#include "studies/heat/coverage.hpp"
#include "studies/selftest/selftest.hpp"

#include <string>

namespace ff::reports {

/// The tables of docs/validation.md, in Markdown.
std::string selftest_markdown(const studies::Selftest& selftest);

/// Measured rates beside their claims, a row each, under the table's title.
std::string rate_table_markdown(const studies::RateTable& table, double level);

/// What `ffstudy form_factors_selftest` prints.
std::string form_factor_coverage_markdown(const studies::FormFactorCoverage& coverage);

/// What `ffstudy heat_selftest` prints.
std::string flow_coverage_markdown(const studies::FlowCoverage& coverage);

}  // namespace ff::reports
