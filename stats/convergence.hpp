#pragma once

#include "stats/interval.hpp"
#include "stats/line_fit.hpp"
#include "stats/resampling.hpp"

#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// One size of a ladder: the errors (estimate - truth) of its independent replicates.
struct Rung {
    double size = 0;  ///< evaluations N > 0
    std::vector<double> errors;
};

/// Rate r of "error ~ N^r": the slope of ln(error) on ln(N), -0.5 for plain Monte Carlo.
struct ConvergenceRate {
    double rate = 0;
    Interval interval;                    ///< "wls_normal" from the fit's weights
    Interval bootstrap;                   ///< "percentile_bootstrap" over replicates within each size
    std::optional<double> lack_of_fit_p;  ///< of a straight line; empty for two sizes and for medians
    double kurtosis_factor = 1;           ///< by which the variances of normal errors were multiplied
    std::size_t points = 0;
};

/// Rate of the root mean squared error. Weights: Var(ln MSE) = trigamma(R/2) for R normal errors, times
/// max(1, 1 + excess kurtosis / 2) (pooled over sizes). Assumes a finite fourth moment: show the median rate beside it.
/// Empty below two sizes, below two replicates at one, or where all errors of one are 0.
std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan);

/// Rate of the median absolute error, which survives infinite variance. `interval` repeats the bootstrap one.
/// Empty below two sizes or where a median is 0.
std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan);

/// Variance of the logarithm of a mean of squares of `freedom` independent standard normals: trigamma(freedom / 2).
double log_chi_squared_variance(double freedom);

}  // namespace ff::stats
