#pragma once

#include "core/estimators/estimator.hpp"
#include "tests/support/philox_points.hpp"

#include <vector>

namespace ff::test {

/// What a trial of an estimator observes, with independent points where it takes some.
/// @param patches  per face
template <class T>
Outcome observe(const T& estimator, std::uint32_t patches, std::uint64_t samples, std::uint32_t trial = 0) {
    const PhiloxPoints points(samples);
    Outcome outcome;
    PatchTotals totals;
    estimator.observe(
        {.subdivision = {patches}, .points = &points, .samples = samples, .options = {}, .key = {1, 2}, .trial = trial},
        outcome, totals);
    return outcome;
}

template <class T>
Outcome observe(const Scene& scene, std::uint32_t patches, std::uint64_t samples) {
    return observe(T(scene, TracerChoice::automatic), patches, samples);
}

/// The estimate of one factor in each trial.
template <class T>
std::vector<double> estimates(const Scene& scene, std::uint32_t patches, std::uint64_t samples, std::uint32_t trials,
                              int from, int to) {
    const T estimator(scene, TracerChoice::automatic);
    std::vector<double> result;
    for (std::uint32_t trial = 0; trial < trials; ++trial)
        result.push_back(observe(estimator, patches, samples, trial).estimates(from, to));
    return result;
}

}  // namespace ff::test
