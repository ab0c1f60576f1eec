#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A line for each method and size whose trials seem to have infinite variance.
std::vector<std::string> heavy_tails_in_brief(const studies::StudyResults& results);

/// The stopping rule in a sentence, then one sentence for all cells that reached it and one for each that did not;
/// empty where the study is not adaptive or not complete.
std::vector<std::string> until_in_brief(const studies::StudyResults& results);

/// A line about the apparent errors of single runs if dependent rays are treated as independent; empty where all are
/// independent.
std::vector<std::string> one_run_errors_in_brief(const studies::StudyResults& results);

/// "5.3 [4.1, 6.9]": the factor of variance reduction, and its interval.
std::string factor_text(const studies::VarianceReduction& reduction);

/// The samplers with the least variance, as far as they can be distinguished, at each size (of a ladder: at the
/// largest) and on each class of pairs, and the effect of one sequence over all patches of a face; empty where nothing
/// is compared with random points.
std::vector<std::string> reductions_in_brief(const studies::StudyResults& results);

/// Findings of a study beyond the errors of its methods, a sentence each: heavy tails, slopes, variances, coverage,
/// stopping rules, error laws.
std::vector<std::string> results_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports
