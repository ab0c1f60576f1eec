#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::reports {

/// Who comes first and who last, of methods that are measured side by side. Nothing else in the reports may say so. A
/// name stands only for what is told apart at the study's level over all pairs of methods (studies/comparison/ranking),
/// which pays for having picked the best, or the worst, of many: the first of those that no other is, the last where it
/// differs from every other. Clauses begin with "on parallel pairs"; empty where there is nothing to say.

/// A clause as a sentence of its own.
std::string sentence(std::string clause);

/// How fast errors fall, on a class of pairs.
std::string rate_clause(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

/// Whose errors are smallest, at sizes that can be compared.
std::string error_clause(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

/// Which of these methods and sizes have the smallest errors; "" where none has a variance.
std::string smallest_errors(const studies::Findings& findings, std::span<const std::size_t> cells,
                            PairClass pair_class);

/// Which of these methods and sizes have the smallest errors for their evaluations, and what factor all of them span;
/// "" where fewer than two have a variance.
std::string largest_efficiencies(const studies::Findings& findings, std::span<const std::size_t> cells,
                                 PairClass pair_class);

/// Whose variance is least beside that of a cell with random points.
std::string variance_clause(const studies::StudyResults& results, std::size_t random_cell, PairClass pair_class);

}  // namespace ff::reports
