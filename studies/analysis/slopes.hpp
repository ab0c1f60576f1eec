#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/plan/ladders.hpp"
#include "studies/theory/expected_rate.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::studies {

/// The measure of error that a slope belongs to.
enum class ErrorSize { rmse, median_abs_error };
std::string_view name(ErrorSize size);

/// How fast the error falls with the number of evaluations N: the slope of its logarithm on ln N.
struct Slope {
    std::optional<Quantity> pair;  ///< empty for all pairs of a class together
    PairClass pair_class = PairClass::other;
    ErrorSize statistic = ErrorSize::rmse;
    VarianceStatus variance = VarianceStatus::finite;
    std::size_t points = 0;       ///< sizes in the fit
    std::optional<double> slope;  ///< empty without variance (rmse), or where the error is rounding
    /// Bootstrap over whole trials; for the rmse what covers it and `interval_from_fit`. Empty for deterministic
    /// methods.
    std::optional<stats::Interval> interval;
    std::optional<stats::Interval> interval_from_fit;  ///< from the weights of the fit; rmse only
    std::optional<double> lack_of_fit_p;  ///< p-value of a straight line; rmse only. Where small, by the rule for means
    bool may_bend = false;                ///< by chi-squared a straight line does not fit, at the level of one test
    double misfit = 1;                    ///< sqrt(chi-squared / degrees of freedom) of a straight line, at least 1
    std::optional<ExpectedRate> expected;
    double slowest_expected = 0;  ///< ExpectedRate::slowest at the middle of the ladder
    std::optional<double> p;      ///< p-value of the slope being as expected
    bool few_trials = false;      ///< few at some size, or they repeat each other: there is neither an interval nor a p
};

/// The interval of a slope at another level, under a normal law, and wider by its misfit where a straight line may not
/// fit. Empty where the slope has no interval.
std::optional<stats::Interval> interval_with_misfit(const Slope& slope, double level);

/// The comparison of theory and trials for a class of pairs.
enum class RateFinding {
    as_expected,  ///< no difference found at the study's level, over all classes of all methods together (Holm)
    slower,
    faster,  ///< than expected
    no_theory,
    no_slope,  ///< deterministic, no variance, few trials, or errors of rounding only
};

struct ClassSlopes {
    PairClass pair_class = PairClass::other;
    std::size_t pairs = 0;
    Slope rmse;
    Slope median;
    std::vector<ClassError> sizes;
    std::optional<double> adjusted_p;  ///< Holm over all classes of all ladders with an expected rate
    RateFinding finding = RateFinding::no_slope;
    bool bent = false;  ///< not a straight line: at the study's level over all classes of all ladders (Holm)

    /// The slope that is compared with theory: of the RMSE, or of the median where there is no variance.
    [[nodiscard]] const Slope& judged() const { return rmse.variance == VarianceStatus::infinite ? median : rmse; }
};

struct LadderSlopes {
    Ladder ladder;
    std::vector<ClassSlopes> classes;
    std::vector<Slope> pairs;  ///< rmse and median of every distinct pair
};

/// Resamples behind the intervals of a ladder's slopes, by the total number of trials: as many as their cost allows,
/// with (resamples + 1) / 40 whole.
std::uint32_t resamples_of_ladder(std::uint64_t trials);

/// Slopes of all ladders of a complete study. Pure.
std::vector<LadderSlopes> fit_slopes(const CellReader& cells, const Analysis& findings);

}  // namespace ff::studies
