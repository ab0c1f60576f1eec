#pragma once

#include "studies/audit/correction.hpp"
#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment_model.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies::audit {

/// A diagnosis with the corrections that it asks for.
struct JudgedDiagnosis {
    Diagnosis diagnosis;
    std::vector<Correction> corrections;  ///< one per blamed suspect that has figures
    /// Its improbability in powers of ten: one per digit that must change, plus that of corrected Monte Carlo values
    /// and of what it leaves of deterministic ones far from the true factors.
    double improbability = 0;
};

/// All diagnoses of a model, the most plausible first.
std::vector<JudgedDiagnosis> judge_diagnoses(const ExperimentModel& model);

/// The constraint of a suspect's figures.
const Constraint& constraint_of(const ExperimentModel& model, std::size_t suspect);

/// Rays behind a constraint that prints one sampled quantity; empty for all others.
std::optional<std::uint64_t> rays_of(const ExperimentModel& model, const Constraint& constraint);

}  // namespace ff::studies::audit
