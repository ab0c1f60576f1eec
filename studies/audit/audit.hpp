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
#include <utility>
#include <vector>

namespace ff::studies::audit {

enum class Severity {
    contradiction,  ///< the printed figures cannot all be right
    note,           ///< worth knowing, but nothing is wrong
};

/// The evidence of one relation about a blamed figure.
struct Evidence {
    Relation relation = Relation::print;
    std::string text;                  ///< a sentence
    std::vector<std::size_t> figures;  ///< the figures that it rests on
};

/// An error in what is printed.
struct Finding {
    std::string id;  ///< stable: the same contradiction has the same id in every audit of the same file
    Severity severity = Severity::contradiction;
    Relation relation = Relation::print;  ///< relation that the first evidence is about
    std::string statement;                ///< a sentence
    std::vector<std::size_t> blamed;      ///< figures; may be empty where a verbal statement is wrong
    std::vector<Correction> corrections;  ///< what blamed figures should say, equal corrections once
    std::vector<Evidence> evidence;
    std::vector<std::string> alternatives;  ///< other possible culprits, a sentence each
    std::vector<std::size_t> involved;      ///< all figures that blame, evidence or alternatives mention, ascending

    void cite(Relation by, std::string text, std::vector<std::size_t> figures = {}) {
        evidence.push_back({by, std::move(text), std::move(figures)});
    }
};

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
    std::vector<Finding> findings;  ///< contradictions first, in the order of the tables
    std::vector<InferredFormat> formats;
    ReferenceInference references;
    std::vector<ReadingEvidence> readings;
    std::vector<RecoveredHits> hits;
    std::vector<ExperimentSpread> spreads;
    double alpha = 0;  ///< family-wise, of all statistical tests together
    std::size_t plausibility_tests = 0;
    double z_limit = 0;  ///< standard deviations from which one Monte Carlo value is impossible

    [[nodiscard]] std::size_t contradictions() const;
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
