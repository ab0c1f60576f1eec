#pragma once

#include "studies/audit/findings.hpp"
#include "studies/audit/references.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ff::studies::audit {

/// The number format of a method's form factors and row sums.
struct InferredFormat {
    std::string method;
    NumberFormat format;
    std::vector<NumberFormat> candidates;  ///< possible formats, the one that is most likely by itself first
    std::vector<FormatEvidence> evidence;  ///< evidence for each candidate; sampling methods only
};

/// Infers the format of a method from its single figures. For a sampling method, a format is the more likely the
/// more figures are whole numbers of hits in it; tables with several readings count only where there are no others. A
/// deterministic one has fixed decimals, unless the figures' lengths vary as with significant digits. The first
/// candidate is chosen, but one that is not rounded or truncated as stated only where the odds for it are overwhelming.
/// @pre the method has figures in the tables
InferredFormat infer_format(const PublishedTables& tables, const std::string& method);

/// The criteria by which experiments are judged.
struct Judgement {
    const PublishedTables& tables;
    const SceneFacts& facts;
    DistributionCache& cache;
    const ReferenceInference& references;
    double z_limit = 0;       ///< limit for single Monte Carlo values
    double spread_level = 0;  ///< level of the chi-squared test of an experiment, on either side
};

/// The candidate with which the fewest causes explain all contradictions of a method's experiments; among several, the
/// one that is most likely by itself. One that is not rounded or truncated as stated must save so many misprints that
/// the odds for it are overwhelming.
/// @param experiments  those of the method
NumberFormat choose_format(const Judgement& judgement, std::span<const Experiment> experiments,
                           const InferredFormat& inferred);

/// A finding where the publication does not print a method's figures as it says; empty where it does, or does not say.
std::optional<Finding> judge_printing_rule(const PublishedTables& tables, const InferredFormat& inferred);

}  // namespace ff::studies::audit
