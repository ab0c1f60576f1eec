#pragma once

#include "core/scene.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <ostream>
#include <string>

namespace ff::reports {

/// What `ffstudy form_factors` writes; docs/form-factors.md says what the columns and keys are.

/// A matrix of form factors with what it is of.
struct FormFactorReport {
    const Scene& scene;
    const studies::FormFactorRequest& request;
    const studies::FormFactorMatrix& matrix;
};

/// For the terminal: methods and why, the matrix where it is small, row sums, what misses the tolerance.
std::string form_factors_text(const FormFactorReport& report);

/// matrix.csv: a row for each ordered pair of faces that is not 0 by geometry.
void write_form_factors_csv(std::ostream& out, const FormFactorReport& report);

/// form_factors.json
std::string form_factors_json(const FormFactorReport& report);

/// Sentences about what should not be: row sums of closed scenes that exclude 1, lost rays, contradictions.
std::vector<std::string> form_factor_warnings(const FormFactorReport& report);

}  // namespace ff::reports
