#pragma once

#include "studies/audit/constraint_system.hpp"
#include "studies/audit/correction.hpp"
#include "studies/audit/experiment.hpp"
#include "studies/audit/hit_counts.hpp"
#include "studies/audit/references.hpp"
#include "studies/audit/scene_facts.hpp"
#include "studies/audit/spread.hpp"
#include "studies/audit/value_format.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

enum class Severity {
    contradiction,  ///< what is printed cannot all be right
    note,           ///< worth knowing, nothing is wrong
};

/// What one relation says about a blamed figure.
struct Evidence {
    Relation relation = Relation::print;
    std::string text;                  ///< a sentence
    std::vector<std::size_t> figures;  ///< that it rests on
};

/// Something that is wrong with what is printed.
struct Finding {
    std::string id;  ///< stable: the same contradiction has the same id in every audit of the same file
    Severity severity = Severity::contradiction;
    Relation relation = Relation::print;  ///< of the first evidence
    std::string statement;                ///< a sentence
    std::vector<std::size_t> figures;     ///< blamed; may be empty where a statement in words is wrong
    std::vector<Correction> corrections;  ///< of blamed figures, equal ones once
    std::vector<Evidence> evidence;
    std::vector<std::string> alternatives;  ///< who else may be to blame, a sentence each
    std::vector<std::size_t> involved;      ///< all figures that blame, evidence or alternatives mention, ascending
};

/// Whole numbers of hits behind a figure of a sampling method.
struct RecoveredHits {
    std::size_t figure = 0;
    std::uint64_t rays = 0;              ///< of the figure's face
    std::optional<HitRange> printed;     ///< that the print alone allows; empty where no whole number is printed so
    std::optional<HitRange> consistent;  ///< that all relations together allow
};

/// Monte Carlo values of one experiment together, misprints corrected.
struct SpreadFinding {
    std::string experiment;
    Spread spread;
};

/// Everything that an audit finds out. All indices are into the tables' `figures`.
struct AuditReport {
    std::string source;
    std::size_t figures = 0;
    std::vector<Finding> findings;  ///< contradictions first, in the order of the tables
    std::vector<FormatFinding> formats;
    ReferenceInference references;
    std::vector<ReadingEvidence> readings;
    std::vector<RecoveredHits> hits;
    std::vector<SpreadFinding> spreads;
    double alpha = 0;  ///< family-wise, of all statistical tests together
    std::size_t plausibility_tests = 0;
    double z_limit = 0;  ///< standard deviations from which one Monte Carlo value is impossible

    [[nodiscard]] std::size_t contradictions() const;
};

struct AuditOptions {
    /// Probability that chance alone makes the audit of correct tables report a contradiction: half for single Monte
    /// Carlo values, half for chi-squared tests of experiments.
    double alpha = 1e-4;
};

/// Finds every contradiction in published tables, from the printed digits alone, and whom to blame for it: the fewest
/// causes whose correction removes all contradictions, then the one that is nearest to a slip of the pen.
/// Pure; the same tables give the same report.
/// @throws UserError where the scene is unknown or a figure names a face that it does not have
AuditReport audit(const PublishedTables& tables, const AuditOptions& options = {});

/// The same for many audits of tables of one scene.
AuditReport audit(const PublishedTables& tables, const AuditOptions& options, DistributionCache& cache);

}  // namespace ff::studies
