#pragma once

#include "studies/audit.hpp"
#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// A diagnosis with the corrections that it asks for.
struct JudgedDiagnosis {
    Diagnosis diagnosis;
    std::vector<Correction> corrections;  ///< one a blamed suspect that has figures
    /// Powers of ten by which it is unlikely: one a digit that must change, and the improbability of corrected Monte
    /// Carlo values.
    double improbability = 0;
};

/// All diagnoses of a model, the most plausible first.
std::vector<JudgedDiagnosis> judge_diagnoses(const PublishedTables& tables, const SceneFacts& facts,
                                             const ExperimentModel& model, const Interpretation& interpretation);

/// The findings that the first diagnosis amounts to; the others become alternatives. Blamed figures about the same
/// quantity make one finding.
std::vector<Finding> explain_diagnosis(const PublishedTables& tables, const SceneFacts& facts,
                                       const Experiment& experiment, const ExperimentModel& model,
                                       const Interpretation& interpretation,
                                       const std::vector<JudgedDiagnosis>& diagnoses);

/// A figure's place and digits, e.g. `table4, Σ of face 3, SR ("0.97264")`.
std::string quote(const PublishedTables& tables, std::size_t figure);

}  // namespace ff::studies
