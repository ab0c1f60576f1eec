#pragma once

#include "studies/audit/audit.hpp"
#include "studies/audit/experiment.hpp"
#include "studies/audit/experiment_model.hpp"
#include "studies/audit/references.hpp"
#include "studies/audit/scene_facts.hpp"
#include "studies/audit/spread.hpp"
#include "studies/audit/value_format.hpp"

#include <optional>
#include <span>
#include <vector>

namespace ff::studies::audit {

/// The criteria by which experiments are judged.
struct Judgement {
    const PublishedTables& tables;
    const SceneFacts& facts;
    DistributionCache& cache;
    const ReferenceInference& references;
    double z_limit = 0;       ///< limit for single Monte Carlo values
    double spread_level = 0;  ///< level of the chi-squared test of an experiment, on either side
};

/// Whether chi-squared finds the values too far from, or too close to, the exact ones.
bool is_implausible(const JointDistance& spread, double level);

/// The candidate with which the fewest causes explain all contradictions of a method's experiments; among several, the
/// one that is most likely by itself. One that is not rounded or truncated as stated must save so many misprints that
/// the odds for it are overwhelming.
/// @param experiments  those of the method
NumberFormat choose_format(const Judgement& judgement, std::span<const Experiment> experiments,
                           const InferredFormat& inferred);

/// A finding where the publication does not print a method's figures as it says; empty where it does, or does not say.
std::optional<Finding> judge_printing_rule(const PublishedTables& tables, const InferredFormat& inferred);

}  // namespace ff::studies::audit
