#pragma once

#include "studies/comparison/ranking.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {

// Which of the methods that are measured side by side comes first, and which last. Nothing else in the reports may say
// so. A method is named only where it differs from all others at the study's level over all pairs of methods
// (studies/comparison/ranking), which allows for having picked the best, or the worst, of many.

/// One of the methods that a ranking shows.
struct RankedMethod {
    std::string label;
    std::size_t method = 0;       ///< index into StudySpec::methods
    std::string size;             ///< empty where several are taken together
    std::optional<double> value;  ///< empty where it is rounding
    std::optional<stats::Interval> interval;
    std::optional<double> expected;
    std::string group;  ///< a letter, a for the best, or another mark; empty where all are in one group
};

/// Methods that are measured side by side, best first, and who comes first and last of them.
struct Ranking {
    std::string heading = {};  ///< "adjacent pairs", "cube: adjacent pairs"
    std::vector<RankedMethod> methods = {};
    std::size_t scene = 0;
    PairClass pair_class = PairClass::other;
    std::string said = {};   ///< a clause that follows the name of the pairs: " SR has the smallest error"
    std::string brief = {};  ///< the same in a few words: " SR errs 4.9 times less than PDM (4.6 to 5.2)"
    /// Labels of the methods that nothing is shown to be better than; empty where no method is shown to be better than
    /// another.
    std::vector<std::string> leaders = {};
    std::string margin = {};  ///< lead of a single leader: "errs 4.9 times less than PDM (4.6 to 5.2)"
    /// The interval of how many times less it errs than the next; empty where that is not known.
    std::optional<std::pair<double, double>> ahead = {};
    std::string cost = {};  ///< the evaluations that this takes: " with 845 times fewer evaluations"
    std::string but = {};   ///< what speaks against taking the leaders: "at equal evaluations a errs less"; often empty
    std::string caveat = {};    ///< a sentence on what is not ranked; may be empty
    std::string again = {};     ///< the margin after one of the same kind: "4.9 times (4.6 to 5.2)"; may be empty
    std::string at = {};        ///< what is equal for all, where rankings differ in it: " with 1 × 625 rays"
    std::string measured = {};  ///< " (median error)" where rates are not those of the RMSE
    /// Cell whose variance the others are compared with; for variances only.
    std::optional<std::size_t> random_cell = {};
};

/// "On parallel pairs SR has the smallest error."
std::string sentence(const Ranking& ranking, const studies::StudyPlan& plan);

/// How fast errors fall, on each class of pairs of each scene that has slopes.
std::vector<Ranking> rank_rates(const studies::StudyResults& results);

/// Which methods have the smallest errors at comparable sizes, on each class of pairs of each scene.
std::vector<Ranking> rank_compared_errors(const studies::StudyResults& results);

/// Which methods have the least variance, for each cell with random points that they are compared with.
std::vector<Ranking> rank_variances(const studies::StudyResults& results);

/// A cell in a ranking of cells.
RankedMethod ranked_cell(const studies::StudyPlan& plan, const studies::Ranked& one, std::string group);

/// Which of these methods and sizes have the smallest errors; "" where none has a variance.
std::string smallest_errors(const studies::Analysis& findings, std::span<const std::size_t> cells,
                            PairClass pair_class);

/// Which of these methods and sizes have the smallest errors for their evaluations, and by what factor all of them
/// differ; "" where fewer than two have a variance.
std::string largest_efficiencies(const studies::Analysis& findings, std::span<const std::size_t> cells,
                                 PairClass pair_class);

}  // namespace ff::reports
