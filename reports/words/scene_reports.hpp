#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A matrix of form factors with its scene. docs/form-factors.md describes what is written of it.
struct FormFactorReport {
    const Scene& scene;
    const studies::form_factors::Request& request;
    const studies::form_factors::Matrix& matrix;
};

/// Sentences about suspicious findings: row sums of closed scenes that exclude 1, lost rays, contradictions.
std::vector<std::string> form_factor_warnings(const FormFactorReport& report);

}  // namespace ff::reports
