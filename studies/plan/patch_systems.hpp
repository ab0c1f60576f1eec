#pragma once

#include "studies/plan/plan.hpp"

#include <cstddef>
#include <cstdint>

namespace ff::studies {

/// Most patches of a scene between which systems are solved: 800 MB per matrix, of which several are needed at a time.
/// Sums of kernels are kept for every pair meanwhile.
inline constexpr std::uint32_t most_traced_patches = 10'000;
inline constexpr std::uint32_t most_kernel_patches = 3000;

/// Whether a trial of the cell gives factors between patches: rays and kernels do, where faces are divided.
bool tells_patches_apart(const StudyPlan& plan, std::size_t index);

/// Whether the study asks for systems between the patches of this cell.
bool has_patch_systems(const StudyPlan& plan, std::size_t index);

/// How many of the cell's trials enter them.
std::uint64_t patch_trials(const StudyPlan& plan, std::size_t index);

/// @throws UserError where a cell has more patches than the limit above, or lacks exact factors
/// @pre tells_patches_apart
void expect_few_patches(const StudyPlan& plan, std::size_t index);

}  // namespace ff::studies
