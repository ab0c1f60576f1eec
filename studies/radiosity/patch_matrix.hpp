#pragma once

#include "studies/plan.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ff::studies {

/// Most patches of a scene for which `trace_patch_factors` gives a matrix: it has 32 MB.
inline constexpr std::uint32_t most_traced_patches = 2000;

/// Direct factors between the patches of a trial of ray shooting. No store holds them; the rays of the trial are traced
/// again: they are the same, since points are addressed.
/// @return empty for other estimators, for one patch a face, and beyond most_traced_patches
std::optional<Eigen::MatrixXd> trace_patch_factors(const StudyPlan& plan, std::size_t cell, std::uint64_t trial);

}  // namespace ff::studies
