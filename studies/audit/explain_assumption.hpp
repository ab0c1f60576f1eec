#pragma once

#include "studies/audit/audit.hpp"
#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment_model.hpp"

#include <cstddef>
#include <string>

namespace ff::studies::audit {

/// Says why the assumption of a blamed suspect does not hold, and adds the evidence to `finding`.
std::string explain_assumption(const PublishedTables& tables, const SceneFacts& facts, const Experiment& experiment,
                               const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                               Finding& finding);

}  // namespace ff::studies::audit
