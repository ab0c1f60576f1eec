#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/readers/names.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::studies {

/// The rule by which a group of trials yields an interval.
enum class IntervalRule {
    student_t,
    normal,
    percentile_bootstrap,
    two_stage,   ///< Stein's: R trials are the pilot and determine how many follow
    look_short,  ///< trials are added to R one by one until Student's interval is short enough; broken on purpose
};

template <>
inline constexpr auto names_of<IntervalRule> =
    name_table(Named{IntervalRule::student_t, "student_t"}, Named{IntervalRule::normal, "normal"},
               Named{IntervalRule::percentile_bootstrap, "percentile_bootstrap"},
               Named{IntervalRule::two_stage, "two_stage"}, Named{IntervalRule::look_short, "look_short"});

/// How often intervals of one rule contain the exact value.
struct Coverage {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    IntervalRule interval_method = IntervalRule::student_t;
    std::uint64_t replicates = 0;  ///< R: trials per group, or in its first stage
    std::uint64_t intervals = 0;
    std::uint64_t covered = 0;
    double mean_trials = 0;                  ///< mean number of trials per group
    stats::Interval coverage_interval = {};  ///< Clopper-Pearson, of the coverage, at the study's level
    bool short_of_nominal = false;           ///< significantly, at the study's level over all rows together (Sidak)

    [[nodiscard]] double share() const { return static_cast<double>(covered) / static_cast<double>(intervals); }
};

/// Cuts the trials of each sampled cell into groups of R and makes an interval of each, for StudySpec::coverage. From
/// each source face one target of each class is taken: such pairs have no point in common, so that intervals are
/// independent. Stopping rules aim at the half-width that 4 R trials have on average. Pure.
std::vector<Coverage> measure_coverage(const CellReader& cells);

/// Who claims an error.
enum class Claimant {
    estimator,  ///< for each factor in each trial: Outcome::claims
    study,      ///< one for all: Method::claimed_error
    one_run,    ///< hits treated as independent: binomial standard error times the normal quantile
};

template <>
inline constexpr auto names_of<Claimant> = name_table(Named{Claimant::estimator, "estimator"},
                                                      Named{Claimant::study, "study"},
                                                      Named{Claimant::one_run, "one_run"});

enum class ClaimedErrorFinding {
    holds,  ///< no claim was wrong; where not all have to hold, no share is significantly too small
    fails,  ///< some claim was wrong; where not all have to hold, a pair's share is significantly too small
};

/// How often a claimed error holds on the pairs of a class that have an exact value.
struct ClaimedErrors {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    Claimant claimant = Claimant::estimator;
    double promised = 1;       ///< share of claims that has to hold
    std::uint64_t claims = 0;  ///< pairs times trials
    std::uint64_t held = 0;
    Quantity worst_pair = {};  ///< the pair with the fewest claims that hold
    std::uint64_t worst_held = 0;
    std::size_t pairs = 0;
    /// Clopper-Pearson interval on that pair from all runs, corrected for all pairs of all rows (Bonferroni).
    stats::Interval worst_share_interval = {};
    double median_ratio = 0;  ///< median of |error| / claim
    double largest_ratio = 0;
    ClaimedErrorFinding finding = ClaimedErrorFinding::holds;

    [[nodiscard]] double share() const { return static_cast<double>(held) / static_cast<double>(claims); }
};

/// Judges every method that claims errors or counts hits. Errors below 1e-12 are rounding; their claims hold.
std::vector<ClaimedErrors> judge_claimed_errors(const CellReader& cells);

}  // namespace ff::studies
