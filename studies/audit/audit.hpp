#pragma once

#include "studies/audit/findings.hpp"
#include "studies/audit/references.hpp"
#include "studies/audit/value_format.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::audit {

/// Whole numbers of hits behind a figure of a sampling method.
struct RecoveredHits {
    std::size_t figure = 0;
    std::uint64_t rays = 0;                ///< number of rays shot from the figure's face
    std::optional<HitRange> printed{};     ///< allowed by the printed digits alone; empty where no whole number fits
    std::optional<HitRange> consistent{};  ///< allowed by all relations together
};

/// The Monte Carlo values of one experiment taken together, misprints corrected.
struct ExperimentSpread {
    std::string experiment;
    JointDistance spread;
};

/// All findings of an audit. All indices are into the tables' `figures`.
struct Report {
    std::string source;
    std::size_t figures = 0;
    std::vector<Finding> findings;  ///< in the order of the tables
    std::vector<InferredFormat> formats;
    ReferenceInference references;
    std::vector<ReadingEvidence> readings;
    std::vector<RecoveredHits> hits;
    std::vector<ExperimentSpread> spreads;
    double alpha = 0;  ///< family-wise, of all statistical tests together
    std::size_t plausibility_tests = 0;
    double z_limit = 0;  ///< standard deviations from which one Monte Carlo value is impossible

    [[nodiscard]] std::size_t contradictions() const { return findings.size(); }
};

struct ExamineOptions {
    /// Probability that the audit of correct tables reports a contradiction by chance alone: half for single Monte
    /// Carlo values, half for chi-squared tests of experiments.
    double alpha = 1e-4;
};

/// Finds every contradiction in published tables, from the printed digits alone, and its likely causes: the fewest
/// whose correction removes all contradictions, and among these the closest to a slip of the pen. Pure; the same tables
/// give the same report.
/// @throws UserError where the scene is unknown or a figure names a face that it does not have
Report examine(const PublishedTables& tables, const ExamineOptions& options = {});

/// The same, for many audits of tables of one scene.
Report examine(const PublishedTables& tables, const ExamineOptions& options, DistributionCache& cache);

}  // namespace ff::studies::audit
