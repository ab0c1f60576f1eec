#pragma once

#include "reports/words/findings/standing.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::reports {

/// Kinds of pairs on which the same methods are best in the most cases.
struct BestOnKinds {
    std::vector<std::string> methods;
    std::vector<std::string> kinds;
    std::size_t best = 0;  ///< cases where nothing is shown to be better than one of them
    std::size_t ran = 0;   ///< cases that one of them can do
};

/// One method for each kind, in a clause for each method; the last one counts the cases. Of the methods that are best
/// on a kind it is the one that is best in the most cases of all kinds.
std::vector<std::string> clauses_with_one_method(const std::vector<BestOnKinds>& kinds);

/// The methods that are best in the most cases (scenes and classes of pairs), for each kind of pairs.
struct BestChoices {
    std::vector<Ranking> rankings;     ///< by the share of cases, for each kind
    std::vector<std::string> clauses;  ///< "at equal evaluations take a or b on parallel pairs (best in 5 of 5 cases)"
    /// The same in fewer words: one method for each kind; then without kinds of one case, then without those of two.
    std::vector<std::vector<std::string>> shorter;
};

/// Empty where a study has one scene, or no sizes to compare.
BestChoices best_choices(const studies::StudyResults& results);

}  // namespace ff::reports
