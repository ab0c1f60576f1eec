#pragma once

#include "studies/audit/audit.hpp"
#include "studies/published/published.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace ff::reports {

/// How many contradictions there are, in a sentence.
std::string audit_verdict(const studies::audit::Report& report);

/// The audit in a few lines for a terminal: the verdict, then one line per finding, with the line of the tables file
/// where its first figure stands.
std::string audit_summary(const studies::PublishedTables& tables, const studies::audit::Report& report);

/// Our value for a printed figure, with as many decimals as a single run's spread warrants (those of the print for a
/// deterministic value) and the range of a single run; "–" where the study has none.
std::string ours_text(const studies::FigureComparison& comparison, const std::string& printed);

/// The position of a printed figure among ours, in words.
std::string place_text(const studies::FigureComparison& comparison, const std::string& printed);

/// Whether a run as described gives the figure less often than `alpha` allows over its whole table.
bool is_surprising(const studies::FigureComparison& comparison, double alpha);

/// The figures that the audit blames for a contradiction.
std::set<std::size_t> blamed_figures(const studies::audit::Report& audit);

/// " (tested: more evaluations)", to follow the statement of a claim; empty where its file says no more.
std::string tested_as(const studies::PublishedClaim& claim);

/// How many of the publication's claims hold: "The publication's claim is supported." With several claims, the number
/// with each verdict.
std::string claims_sentence(const studies::PublishedResults& published);

/// The same, with the ratio of errors where the first supported claim is about one: "The publication's 2 claims are
/// supported: isocell errs 1.3 to 1.4 times less than random."
std::string claims_with_ratio(const studies::StudyResults& results);

/// A publication in a few sentences: figures outside what a run can give, claims by verdict.
/// @param alpha  family-wise error rate of the figures of a table
std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha);

/// On a deterministic method that, as described, does not give its printed figures: both errors, the costs, and the
/// comparison with the best other method by our figures and by the printed ones. Empty where there is no such method.
/// @pre the study has published tables
std::string premise(const studies::StudyResults& results);

}  // namespace ff::reports
