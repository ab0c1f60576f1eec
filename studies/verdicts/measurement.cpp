#include "studies/verdicts/measurement.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/skewed_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace ff::studies {
namespace {

double passing_level(const Levels& levels) {
    return 1 - 2 * levels.pass_alpha;
}
double failing_level(const Levels& levels) {
    return 1 - levels.fail_alpha;
}

/// The edge beyond which effects are looked for, `shift` further out.
double beyond(const Band& band, double shift) {
    return std::isfinite(band.high) ? band.high + shift : band.low - shift;
}

/// Standard errors between the edge of the band and an effect that fails with the power.
double reach_to_fail(const Levels& levels) {
    return stats::normal_critical(levels.fail_alpha / 2) + stats::normal_critical(1 - levels.power);
}

stats::Interval around(double value, double half_width, const stats::Interval& like) {
    stats::Interval interval = like;
    interval.low = value - half_width;
    interval.high = value + half_width;
    return interval;
}

template <class IntervalOf>
Measurement measured_at(double value, const Levels& levels, const IntervalOf& interval_of) {
    return {.value = value,
            .passing = interval_of(passing_level(levels)),
            .failing = interval_of(failing_level(levels)),
            .minimum_detectable = 0};
}

/// A ratio that lies beyond the band by this factor fails with the power.
double beyond_by_factor(const Band& band, double log_standard_error, const Levels& levels) {
    const double factor = std::exp(reach_to_fail(levels) * log_standard_error);
    return std::isfinite(band.high) ? band.high * factor : band.low / factor;
}

/// Of the logarithm of a root mean square.
double log_variance(const stats::Spread& spread) {
    return 1 / (2 * spread.freedom);
}

/// A mean's standard error with what the reference adds, and its degrees of freedom.
struct Uncertainty {
    double error = 0;
    double freedom = 0;
};

/// Welch and Satterthwaite: error^4 / freedom is the sum of both parts'.
Uncertainty with_reference(const Uncertainty& own, const MeanReference& reference) {
    const double error = std::hypot(own.error, reference.standard_error);
    const auto part = [&](double standard_error, double freedom) {
        return std::pow(standard_error / error, 4) / freedom;
    };
    return {.error = error,
            .freedom = 1 / (part(own.error, own.freedom) + part(reference.standard_error, reference.freedom))};
}

/// Effect beyond the band that fails with the power, the lower limit of the failing interval lying `critical` standard
/// errors below the mean. Quantile of the noncentral t distribution [abramowitz1964] 26.7.10; exact ones cost a
/// millisecond each.
double detectable_mean(const Band& band, const Uncertainty& mean, double critical, double power) {
    const double shift = critical * (1 - 1 / (4 * mean.freedom)) +
                         stats::normal_critical(1 - power) * std::sqrt(1 + critical * critical / (2 * mean.freedom));
    return beyond(band, shift * mean.error);
}

std::string_view method_of_mean(const MeanReference& reference) {
    return reference.standard_error > 0 ? "welch_t" : "student_t";
}

}  // namespace

std::optional<Measurement> measure_mean(const stats::Moments& moments, const MeanReference& reference, const Band& band,
                                        const Levels& levels) {
    FF_EXPECT(moments.reference() == reference.value);
    const auto own = moments.standard_error();
    if (!own || *own == 0) return std::nullopt;
    const Uncertainty mean = with_reference({*own, static_cast<double>(moments.count() - 1)}, reference);
    const auto interval_of = [&](double level) {
        return around(*moments.bias(), stats::student_critical(mean.freedom, (1 - level) / 2) * mean.error,
                      {.level = level, .method = method_of_mean(reference), .n = moments.count()});
    };
    Measurement measurement = measured_at(*moments.bias(), levels, interval_of);
    measurement.minimum_detectable =
        detectable_mean(band, mean, stats::student_critical(mean.freedom, levels.fail_alpha / 2), levels.power);
    return measurement;
}

std::optional<Measurement> measure_unknown_mean(std::span<const double> values, const MeanReference& reference,
                                                const Band& band, const Levels& levels,
                                                const std::optional<stats::Autocorrelation>& correlation) {
    FF_EXPECT(!values.empty());
    // About a value of its own, so that a reference far away costs no digits of the spread.
    const auto moments = stats::moments_of(values, values.front());
    const auto n = static_cast<double>(values.size());
    const double time = correlation ? correlation->time : 1;
    const double effective = n / time;
    const double freedom = (correlation ? std::min(correlation->freedom, effective) : n) - 1;
    const auto independent = moments.standard_error();
    if (values.size() < 3 || *independent == 0 || effective < 2 || freedom < 1) return std::nullopt;
    const Uncertainty mean = with_reference({*independent * std::sqrt(time), freedom}, reference);
    const double value = values.front() - reference.value + *moments.bias();
    const auto reach_at = [&](double tail) { return stats::reach_of_mean(values, effective, mean.freedom, tail); };
    const auto interval_at = [&](const stats::SkewedReach& reach, double level) {
        return stats::Interval{.low = value - reach.below * mean.error,
                               .high = value + reach.above * mean.error,
                               .level = level,
                               .method = reference.standard_error > 0 ? "skewed_welch_t" : "skewed_t",
                               .n = values.size()};
    };
    const auto passing = reach_at(levels.pass_alpha);
    const auto failing = reach_at(levels.fail_alpha / 2);
    return Measurement{.value = value,
                       .passing = interval_at(passing, passing_level(levels)),
                       .failing = interval_at(failing, failing_level(levels)),
                       .minimum_detectable = failing.below_is_open
                                                 ? std::numeric_limits<double>::infinity()
                                                 : detectable_mean(band, mean, failing.below, levels.power),
                       .passing_is_open = passing.below_is_open || passing.above_is_open,
                       .below_is_open = failing.below_is_open,
                       .above_is_open = failing.above_is_open};
}

Measurement measure_spread(const stats::Spread& spread, double reference, const Band& band, const Levels& levels) {
    FF_EXPECT(reference > 0);
    const auto interval_of = [&](double level) {
        stats::Interval interval = stats::square_root(stats::mean_square_interval(spread, level));
        interval.low /= reference;
        interval.high /= reference;
        return interval;
    };
    Measurement measurement = measured_at(std::sqrt(spread.mean_square) / reference, levels, interval_of);
    measurement.minimum_detectable = beyond_by_factor(band, std::sqrt(log_variance(spread)), levels);
    return measurement;
}

Measurement measure_spread(const stats::Spread& spread, const stats::Spread& reference, const Band& band,
                           const Levels& levels) {
    const auto interval_of = [&](double level) { return stats::ratio_interval(spread, reference, level); };
    Measurement measurement = measured_at(std::sqrt(spread.mean_square / reference.mean_square), levels, interval_of);
    measurement.minimum_detectable =
        beyond_by_factor(band, std::sqrt(log_variance(spread) + log_variance(reference)), levels);
    return measurement;
}

Measurement measure_proportion(const stats::Proportion& counts, const Band& band, const Levels& levels) {
    const auto interval_of = [&](double level) { return stats::clopper_pearson_interval(counts, level); };
    Measurement measurement =
        measured_at(static_cast<double>(counts.hits) / static_cast<double>(counts.trials), levels, interval_of);
    const auto deviation = [&](double p) { return std::sqrt(p * (1 - p) / static_cast<double>(counts.trials)); };
    // An upper end of 1 cannot be exceeded; then the lower one is looked beyond.
    measurement.minimum_detectable = band.high < 1
                                         ? std::min(1.0, band.high + reach_to_fail(levels) * deviation(band.high))
                                         : std::max(0.0, band.low - reach_to_fail(levels) * deviation(band.low));
    return measurement;
}

std::optional<Measurement> measure_slope(std::span<const stats::Rung> ladder, const Band& band, const Levels& levels) {
    // One resample: the bootstrap interval does not reach the levels asked for, and is not used.
    const auto fitted =
        stats::fit_rmse_rate(ladder, failing_level(levels), stats::ResamplingPlan{.key = {}, .replicates = 1});
    if (!fitted) return std::nullopt;
    const double error = fitted->interval.width() / 2 / stats::normal_critical(levels.fail_alpha / 2);
    const auto interval_of = [&](double level) {
        stats::Interval interval = fitted->interval;
        interval.level = level;
        return around(fitted->rate, stats::normal_critical((1 - level) / 2) * error, interval);
    };
    Measurement measurement = measured_at(fitted->rate, levels, interval_of);
    measurement.minimum_detectable = beyond(band, reach_to_fail(levels) * error);
    return measurement;
}

Measurement measure_exactly(double value, const Band& band) {
    const stats::Interval point{.low = value, .high = value, .level = 1, .method = "exact", .n = 1};
    return {.value = value,
            .passing = point,
            .failing = point,
            .minimum_detectable = std::isfinite(band.high) ? band.high : band.low};
}

}  // namespace ff::studies
