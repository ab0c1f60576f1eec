#pragma once

#include "tests/support/box_faces.hpp"
#include "tests/support/studies.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::test {

/// Random rays at two sizes, and Sobol' points at the smaller one: cells 0, 1 and 2.
inline constexpr const char* two_methods = R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [100, 10000]
[[method]]
name = "B"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [100]
)";

/// A made-up error of this trial: from -3 to 3 in turn, 0 in the mean of seven trials.
inline double wobble(std::uint64_t trial) {
    return static_cast<double>(trial % 7) - 3.0;
}

/// A study of a cube with errors of +-scale(cell) about the exact values of parallel faces, their sign by trial.
inline studies::Store store_with_errors(const std::vector<double>& scales, const char* methods = two_methods) {
    const auto plan = plan_of(study_text("trials = 70", methods));
    return fill(plan, [&](std::size_t cell, std::uint64_t trial, int from, int to) {
        return (are_opposite(from, to) ? 0.1998249 : 0.20004378) + scales[cell] * wobble(trial);
    });
}

}  // namespace ff::test
