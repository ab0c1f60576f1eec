#pragma once

#include "studies/audit/audit.hpp"
#include "studies/audit/blame.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::studies::audit {

/// The findings of the first diagnosis; other diagnoses become alternatives. Blamed figures about the same quantity
/// make one finding.
std::vector<Finding> explain_diagnosis(const ExperimentModel& model, const std::vector<JudgedDiagnosis>& diagnoses);

/// Says why the assumption of a blamed suspect does not hold, and adds the evidence to `finding`.
std::string explain_assumption(const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                               Finding& finding);

/// "0.19902" or "0.19902 to 0.19903".
std::string in_words(Range range);

/// Figures that a constraint is about: its own, or all prints of its variables.
std::vector<std::size_t> figures_behind(const ExperimentModel& model, const Constraint& constraint);

/// A figure's place and digits, e.g. `table4, Σ of face 3, SR ("0.97264")`.
std::string quote(const PublishedTables& tables, std::size_t figure);

}  // namespace ff::studies::audit
