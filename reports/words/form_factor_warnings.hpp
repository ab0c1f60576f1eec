#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A matrix of form factors with what it is of. docs/form-factors.md says what is written of it.
struct FormFactorReport {
    const Scene& scene;
    const studies::FormFactorRequest& request;
    const studies::FormFactorMatrix& matrix;
};

/// Sentences about what should not be: row sums of closed scenes that exclude 1, lost rays, contradictions.
std::vector<std::string> form_factor_warnings(const FormFactorReport& report);

/// "1 face", "2 faces"
std::string counted(std::size_t number, std::string_view thing);

}  // namespace ff::reports
