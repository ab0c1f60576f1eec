#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/comparison/duel.hpp"
#include "studies/spec/study_difference.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ff::studies {

/// How the trials of two runs of one method and size are related.
enum class Basis {
    independent,            ///< other random numbers: compared by tests
    same_random_numbers,    ///< the same seed and the same points: compared trial by trial, to the bit
    completed_differently,  ///< the same trials, made complete in two ways: neither equal nor independent
    deterministic,          ///< both are deterministic: compared by value
    mixed,                  ///< only one of them is deterministic
};

/// RMSE of a class of pairs in both runs.
struct RmseRatio {
    PairClass pair_class = PairClass::other;
    double first = 0;
    double second = 0;
    std::optional<double> ratio;              ///< second / first; empty where one is rounding
    std::vector<stats::Measured> logarithms;  ///< ln(RMSE) of both; empty unless the runs are independent and vary
    /// Interval of the ratio, where it is finite; all intervals of a comparison hold together.
    std::optional<stats::Interval> interval;
    double adjusted_p = 1;  ///< p-value of equal errors, Holm over all tests of the comparison
};

/// The pair on which two independent runs differ most.
struct Contrast {
    Quantity pair;
    double size = 0;        ///< difference of means, second - first; or ratio of standard deviations, second / first
    double error = 0;       ///< standard error of the difference; 0 for the ratio
    double adjusted_p = 1;  ///< Holm over all tests of the comparison
};

/// Runs count as alike only where a difference of means and one of standard deviations would have been found.
enum class Likeness { alike, different, untestable };

/// Why a pair of two independent runs is not tested.
enum class Untested { few_trials, repeated_trials, not_finite, infinite_variance, too_few_hits, no_spread };

/// The effect that would be detected at the level of the smallest p and with the power, on the worst of the pairs on
/// which any effect would be.
struct Detectable {
    double size = 0;
    std::size_t pairs = 0;  ///< their number; few trials of skewed estimates show nothing
};

/// One scene, method and size that both runs have.
struct CellComparison {
    std::size_t first = 0;  ///< index into the findings of each run
    std::size_t second = 0;
    Basis basis = Basis::independent;
    Likeness likeness = Likeness::untestable;
    std::vector<RmseRatio> ratios;
    std::size_t pairs = 0;
    std::size_t untestable = 0;      ///< pairs without a test
    std::set<Untested> obstacles;    ///< why they have none
    std::optional<Contrast> mean;    ///< independent runs: Welch
    std::optional<Contrast> spread;  ///< independent runs: the rule for means, for squared deviations
    Detectable difference;           ///< detectable difference of means
    Detectable ratio{1, 0};          ///< detectable ratio of standard deviations
    std::size_t trials = 0;          ///< trials that both have; same random numbers only
    std::size_t differing = 0;       ///< trials in which the value of some pair differs
    double largest_difference = 0;   ///< deterministic only, on `largest_pair`
    Quantity largest_pair;
};

/// Which run has the smaller RMSEs, where they differ significantly.
struct Lead {
    std::size_t compared = 0;  ///< tested RMSEs, one per method, size and class of pairs
    std::size_t first = 0;     ///< those where the first run's is significantly smaller
    std::size_t second = 0;
    std::optional<stats::Interval> ratios;   ///< second / first, from the smallest limit to the largest
    std::optional<stats::Interval> decided;  ///< the same for significant ones, larger / smaller
};

/// A scene with the same name that differs between the runs, for example because its file was changed.
struct ChangedScene {
    std::string name;
    std::string difference;  ///< how the faces differ, in words; empty where they are the same: factors are compared
};

/// Two runs side by side.
struct RunComparison {
    std::array<std::string, 2> names;  ///< names by which the user knows the runs
    Analysis first;
    Analysis second;
    std::vector<CellComparison> cells;    ///< in the order of the first run
    std::vector<std::size_t> only_first;  ///< cells without a counterpart
    std::vector<std::size_t> only_second;
    std::vector<Bout> bouts;  ///< of the two methods at equal cost; empty where whole runs are compared
    std::vector<ChangedScene> changed_scenes;
    std::vector<SpecDifference> differences;
    std::size_t tests = 0;  ///< number of tests of means, variances and RMSEs, which share one error rate
    double level = 0.95;    ///< 1 - that error rate; the level of intervals too
    double power = 0.9;

    [[nodiscard]] std::size_t count(Likeness likeness) const;
    /// At the sizes that both have.
    [[nodiscard]] Lead lead() const;
    /// At equal evaluations, in the most informative bouts.
    [[nodiscard]] Lead lead_at_equal_evaluations() const;
};

/// A method of either run.
using MethodNames = std::array<std::string, 2>;

/// Compares what two runs have in common, matched by the names of scene and method and by size; scenes of one name have
/// to have the same faces, by name and shape. If two independent runs
/// are equivalent, the chance that any of their cells is reported as different is at most 1 - level. Level and power
/// are those of the first study. Pure.
/// @param names    of the runs
/// @param methods  one method of each run to compare, whatever their names, at equal sizes and at equal cost; both runs
///                 may then be the same
/// @throws UserError where the runs have nothing in common, or there is no such method
RunComparison compare_runs(const Store& first, const Store& second, std::array<std::string, 2> names = {"A", "B"},
                           const std::optional<MethodNames>& methods = {});

}  // namespace ff::studies
