#pragma once

#include "reports/words/findings/standing.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// "Student's t", "normal quantiles", ...
std::string_view rule_in_words(studies::IntervalRule rule);

/// A line for each rule and number of replicates: the range of its actual coverage over methods and classes of pairs
/// that have a variance, and how often it falls significantly short of the promised level; a line about those without.
std::vector<std::string> coverage_in_brief(const studies::StudyResults& results);

/// The rule that needs the fewest replicates for intervals that nowhere fall significantly short of the promised level
/// and are known to keep it but for 5 %, by the rows whose variance is finite, and the worst of the others.
std::string coverage_advice(const studies::StudyResults& results);

/// The least coverage of each rule and number of replicates, of the same rows.
std::vector<Ranking> least_coverage(const studies::StudyResults& results);

}  // namespace ff::reports
