#pragma once

#include "studies/plan/patch_systems.hpp"

#include <Eigen/Core>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ff::studies::radiosity {

/// Direct factors between the patches of a trial. They are not stored; the trial is repeated, with identical results,
/// since points are addressed. @pre tells_patches_apart @throws Interrupted once `stop` is true
Eigen::MatrixXd trace_patch_factors(const StudyPlan& plan, std::size_t index, std::uint64_t trial,
                                    const std::atomic<bool>* stop = nullptr);

}  // namespace ff::studies::radiosity
