#pragma once

#include "tests/validation/form_factors/coverage.hpp"
#include "tests/validation/gates/selftest.hpp"
#include "tests/validation/heat/coverage.hpp"

#include <string>

namespace ff::studies {

/// What ffstudy-validate prints of what was measured, in Markdown: the tables of docs/validation.md.
std::string markdown(const Selftest& selftest);
std::string markdown(const FormFactorCoverage& coverage);
std::string markdown(const FlowCoverage& coverage);

}  // namespace ff::studies
