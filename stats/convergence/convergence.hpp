#pragma once

#include "stats/basics/interval.hpp"
#include "stats/basics/resampling.hpp"
#include "stats/convergence/line_fit.hpp"
#include "stats/means/mean_test.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// How often each replicate is drawn in each resample of a ladder, with replacement within its rung. Drawn once and
/// shared by all statistics of the same replicates.
///
/// With more than `most_blocks` replicates, blocks of consecutive ones are drawn instead: sums over independent
/// replicates have the same distribution either way, and a spread that 4096 blocks show is known to 1 %.
class LadderDraws {
  public:
    static constexpr std::size_t most_blocks = 4096;

    /// @param replicates  of each rung
    LadderDraws(std::span<const std::size_t> replicates, const ResamplingPlan& plan);

    [[nodiscard]] std::size_t resamples() const { return resamples_; }
    /// Replicates per block; the last block of a rung may have fewer.
    [[nodiscard]] std::size_t block(std::size_t rung) const { return rungs_[rung].block; }
    /// [block]: times drawn.
    [[nodiscard]] std::span<const std::uint32_t> counts(std::size_t resample, std::size_t rung) const;

  private:
    struct RungBlocks {
        std::size_t block = 1;
        std::size_t blocks = 0;
        std::size_t begin = 0;  // place in the counts of a resample
    };

    std::size_t resamples_;
    std::size_t width_ = 0;  // blocks of all rungs
    std::vector<RungBlocks> rungs_;
    std::vector<std::uint32_t> counts_;
};

/// One size of a ladder: the errors (estimate - truth) of its independent replicates. A replicate may have several
/// errors, e.g. those of several pairs of faces in one trial; these may depend on each other and stay together.
struct Rung {
    double size = 0;             ///< evaluations N > 0
    std::vector<double> errors;  ///< [replicate * width + i]
    std::size_t width = 1;       ///< errors of a replicate

    [[nodiscard]] std::size_t replicates() const { return errors.size() / width; }
};

/// Rate r of "error ~ N^r": the slope of ln(error) on ln(N), -0.5 for plain Monte Carlo.
struct ConvergenceRate {
    double rate = 0;
    Interval interval;                    ///< "wls_normal" from the fit's weights
    Interval bootstrap;                   ///< "percentile_bootstrap" over replicates within each size
    double standard_error = 0;            ///< the larger of those behind the two intervals
    std::optional<double> lack_of_fit_p;  ///< p-value of a straight line; empty for two sizes and for medians
    double misfit = 1;                    ///< sqrt(chi-squared / degrees of freedom) of the line, at least 1
    std::size_t points = 0;
};

/// Rate of the root mean squared error over all errors of a size. Weights: Var(ln MSE) = trigamma(R/2) for R normal
/// errors, times half the squared relative variation of a replicate's mean squared error (pooled over sizes): for one
/// error per replicate 1 + excess kurtosis / 2, at least 1; for w errors at least 1 / w, as for independent normal
/// ones. Assumes a finite fourth moment: show the median rate beside it. Empty below two sizes, below two replicates at
/// one, or where all errors of one are 0.
/// @pre widths are equal
std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const LadderDraws& draws);

/// Rate of the median absolute error, which survives infinite variance. `interval` repeats `bootstrap`. Empty below two
/// sizes or where a median is 0.
std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const LadderDraws& draws);

/// The same with its own draws.
std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan);
std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan);

/// The rate of the RMSE as a sum of its parts: half the logarithms of the mean squares, with the weights of the line.
/// Its reaches allow for skewed squares, and for what all evaluations of a size may have missed.
/// @param unmet  of the mean square of each size
/// Empty below two sizes, and where a size has too few replicates or no error.
std::optional<Measured> measured_rmse_rate(std::span<const Rung> ladder, std::span<const Unmet> unmet);

/// P-value of a straight line, by the rule for means: each size is compared with the line through the others
/// (Bonferroni). 1 below three sizes, and where the rule says nothing. @param unmet  as for measured_rmse_rate
double p_of_straight_line(std::span<const Rung> ladder, std::span<const Unmet> unmet);

/// Variance of the logarithm of a mean of squares of `freedom` independent standard normals: trigamma(freedom / 2).
double log_chi_squared_variance(double freedom);

}  // namespace ff::stats
