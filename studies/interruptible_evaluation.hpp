#pragma once

#include "studies/results.hpp"

#include <atomic>

namespace ff::studies {

/// As `evaluate`, but once `stop` is true no further system between patches is begun: one may take minutes. What is
/// found so far is kept.
StudyResults evaluate(const Store& store, const std::atomic<bool>& stop);

/// As `evaluate_radiosity`; null: to the end.
RadiosityResults evaluate_radiosity(const Store& store, const std::atomic<bool>* stop);

/// Trials whose systems between patches are evaluated, and those that should be.
struct PatchTrials {
    std::uint64_t done = 0;
    std::uint64_t wanted = 0;

    [[nodiscard]] bool complete() const { return done == wanted; }
};

PatchTrials patch_trials(const StudyPlan& plan, const RadiosityResults& results);

}  // namespace ff::studies
