#pragma once

#include "core/points/stream.hpp"
#include "core/visibility/pair_class.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/interval.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/trials/estimates.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// Errors of form factors below this are rounding.
inline constexpr double rounding_error = 1e-12;

/// Statistics of one quantity over all trials of a cell. Values that do not exist are empty: no interval for a
/// deterministic method or under infinite variance, no bias without an exact value.
struct Summary {
    Quantity quantity;
    std::optional<PairClass> pair_class;  ///< class of the pair; empty unless the quantity is a form factor
    VarianceStatus variance = VarianceStatus::finite;
    std::size_t trials = 0;
    std::size_t not_finite = 0;  ///< trials that gave infinity or no number; if there are any, the rest is empty
    std::optional<double> reference;
    std::optional<double> mean;
    std::optional<double> bias;
    std::optional<stats::Interval> mean_interval;  ///< as bias_interval, with or without an exact value
    std::optional<double> bias_se;
    std::optional<stats::Interval> bias_interval;
    std::optional<double> minimum_detectable_bias;  ///< at the family-wise level and the power of the study; empty
                                                    ///< where the trials are few, or none is possible
    std::optional<double> std;
    std::optional<stats::Interval> std_interval;
    std::optional<double> rmse;
    std::optional<double> median_abs_error;
    std::optional<double> relative_error_percent;  ///< mean over trials of 100 |estimate - reference| / reference
    std::optional<double> skewness;
    std::optional<double> excess_kurtosis;
    std::optional<double> min, q05, median, q95, max;
    std::optional<double> q025, q975;   ///< 95 % range of a single run
    std::optional<double> normality_p;  ///< Anderson-Darling; hit counts are jittered by half a hit
    std::optional<double> vov;
    std::optional<double> tail_index;
    std::optional<double> efficiency_samples;  ///< 1 / (variance * evaluations per face)
};

/// The data that `summarise` needs besides the values of a quantity.
struct SummaryRequest {
    Quantity quantity;
    std::optional<PairClass> pair_class;
    VarianceStatus variance = VarianceStatus::finite;
    std::optional<double> reference;
    std::optional<double> lattice;  ///< spacing of possible values
    bool binomial = false;          ///< values are hits of independent rays, in units of `lattice`
    stats::KnownLimits limits;      ///< what is known of the values beforehand (stats/means/mean_test.hpp)
    std::uint64_t evaluations_per_face = 0;
    double level = 0.95;               ///< confidence level of intervals
    double detectable_bias = 0;        ///< what the family-wise test finds in this many normal trials of deviation 1
    double pair_alpha = 0.05;          ///< level of that test for one pair
    std::optional<std::size_t> pilot;  ///< trials of the pilot, after two stages
    StreamKey key;                     ///< key of the random numbers of jitter and bootstrap
};

Summary summarise(std::span<const double> values, const SummaryRequest& request);

/// The evidence on the mean of trials, whose number a pilot has fixed where there is one.
std::optional<stats::MeanEvidence> mean_of_trials(std::span<const double> values, double reference,
                                                  std::optional<std::size_t> pilot_trials,
                                                  const stats::KnownLimits& limits);

/// The hits behind shares of independent rays; empty where they vary from trial to trial in a way that binomial hits
/// hardly ever do (once in 10 000), so that they are not what their sampler declares. @pre at least 2 values, 0 <
/// lattice
std::optional<stats::Proportion> binomial_hits(std::span<const double> values, double lattice);

/// The distribution of the errors of single runs, beside a normal one with the same mean and standard deviation.
struct ErrorShape {
    /// Runs with low <= error < high; the last bin includes its upper end.
    struct Bin {
        double low = 0;
        double high = 0;
        std::uint64_t runs = 0;
        double normal = 0;  ///< expected number of runs under a normal distribution
    };
    /// A quantile in standard deviations from the mean.
    struct QuantilePair {
        double normal = 0;
        double runs = 0;
    };

    Quantity quantity;
    double mean = 0;   ///< mean error
    double sigma = 0;  ///< their sample standard deviation
    double q25 = 0;
    double q75 = 0;
    std::vector<Bin> bins;
    std::vector<QuantilePair> quantiles;
};

/// Bins of equal width after Freedman and Diaconis, 8 to 40 of them; for values on a lattice, whole multiples of its
/// spacing, with edges halfway between possible values. Quantiles at (k - 1/2) / m, m = 41 or the number of runs if
/// smaller.
/// @param lattice  spacing of possible values
/// @return empty below 20 values, and for values that are all equal
std::optional<ErrorShape> error_shape(std::span<const double> values, double reference, std::optional<double> lattice);

}  // namespace ff::studies
