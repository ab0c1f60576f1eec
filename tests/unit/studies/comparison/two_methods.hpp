#pragma once

#include <cstdint>

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

}  // namespace ff::test
