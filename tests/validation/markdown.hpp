#pragma once

#include "tests/validation/form_factors/coverage.hpp"
#include "tests/validation/form_factors/facet_coverage.hpp"
#include "tests/validation/gates/selftest.hpp"
#include "tests/validation/heat/coverage.hpp"

#include <string>

namespace ff::studies {

/// The reports of ffstudy-validate in Markdown; both begin with how it was measured.
struct Pages {
    std::string summary;  ///< a row for each table: its claims, and which is nearest to its limit (docs/validation.md)
    std::string tables;   ///< every rate, with what it is about
};

Pages markdown(const gates::Selftest& selftest);
Pages markdown(const form_factors::FormFactorCoverage& coverage);
Pages markdown(const form_factors::FacetCoverage& coverage);
Pages markdown(const heat::FlowCoverage& coverage);

}  // namespace ff::studies
