#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A matrix of form factors with its scene. docs/form-factors.md describes what is written of it.
struct FormFactorReport {
    const Scene& scene;
    const studies::FormFactorRequest& request;
    const studies::FormFactorMatrix& matrix;
};

/// Sentences about suspicious findings: row sums of closed scenes that exclude 1, lost rays, contradictions.
std::vector<std::string> form_factor_warnings(const FormFactorReport& report);

/// Thousands apart, so that counts of samples can be read: "1 234 567".
std::string thousands_apart(std::uint64_t number);

/// "1 face", "2 faces"
std::string counted(std::size_t number, std::string_view thing);

}  // namespace ff::reports
