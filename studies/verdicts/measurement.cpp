#include "studies/verdicts/measurement.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::studies::gates {
namespace {

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

/// A ratio that lies beyond the band by this factor fails with the power.
double beyond_by_factor(const Band& band, double log_standard_error, const Levels& levels) {
    const double factor = std::exp(reach_to_fail(levels) * log_standard_error);
    return std::isfinite(band.high) ? band.high * factor : band.low / factor;
}

/// Approximate variance of the logarithm of a root mean square.
double log_variance(const stats::MeanSquare& spread) {
    return 1 / (2 * spread.freedom);
}

/// Effect beyond the band that fails with the power, the lower limit of the failing interval lying `critical` standard
/// errors below the mean. Quantile of the noncentral t distribution [abramowitz1964] 26.7.10; exact ones cost a
/// millisecond each.
double detectable_mean(const Band& band, const stats::MeanEvidence& mean, double critical, double power) {
    const double shift = critical * (1 - 1 / (4 * mean.freedom)) +
                         stats::normal_critical(1 - power) * std::sqrt(1 + critical * critical / (2 * mean.freedom));
    return beyond(band, shift * mean.standard_error);
}

}  // namespace

std::optional<Measurement> measure_mean(std::span<const double> values, const MeanReference& reference,
                                        const Band& band, const Levels& levels, const stats::KnownLimits& limits,
                                        const std::optional<stats::Autocorrelation>& correlation) {
    const auto own = stats::mean_evidence(values, reference.value, limits, correlation);
    if (!own) return std::nullopt;
    const auto mean = stats::with_uncertain_reference(*own, reference.standard_error, reference.freedom);
    Measurement measurement =
        measured_at(mean.difference, levels, [&](double level) { return stats::interval_of(mean, level); });
    const double unmet = mean.unmet.reach(levels.fail_alpha / 2);
    const double below = (mean.difference - measurement.failing.low - unmet) / mean.standard_error;
    measurement.minimum_detectable = detectable_mean(band, mean, below, levels.power) + unmet;
    return measurement;
}

Measurement measure_spread(const stats::MeanSquare& spread, double reference, const Band& band, const Levels& levels) {
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

std::optional<stats::Measured> logarithm_of_spread(std::span<const double> values, double centre,
                                                   const stats::Unmet& unmet_squares) {
    std::vector<double> squares;
    for (const double value : values) squares.push_back((value - centre) * (value - centre));
    auto mean = stats::mean_evidence(squares, 0);
    if (!mean || mean->difference <= 0) return std::nullopt;
    mean->unmet = unmet_squares;
    return stats::Measured{.value = std::log(mean->difference) / 2,
                           .parts = {{.mean = *mean, .weight = 0.5, .logarithm = true}}};
}

Measurement measure_spread(const stats::MeanSquare& spread, stats::Measured logarithm, double reference,
                           const Band& band, const Levels& levels) {
    Measurement measurement = measure_spread(spread, reference, band, levels);
    logarithm.value -= std::log(reference);
    allow_for_skewness(measurement, logarithm, true, levels);
    const double to_be_noticed = measurement.value / measurement.failing.low *
                                 std::exp(stats::normal_critical(1 - levels.power) * std::sqrt(log_variance(spread)));
    measurement.minimum_detectable = std::max(measurement.minimum_detectable, band.high * to_be_noticed);
    return measurement;
}

Measurement measure_spread(const stats::MeanSquare& spread, const stats::MeanSquare& reference, const Band& band,
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
    // One resample is enough: the bootstrap interval does not reach the requested levels, and is not used.
    const auto fitted =
        stats::fit_rmse_rate(ladder, levels.of_failing(), stats::ResamplingPlan{.key = {}, .replicates = 1});
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

void allow_for_skewness(Measurement& measurement, const stats::Measured& number, bool is_logarithm,
                        const Levels& levels) {
    const auto widen = [&](stats::Interval& interval, double level) {
        const double low = number.value - number.reach(-1, (1 - level) / 2);
        const double high = number.value + number.reach(1, (1 - level) / 2);
        interval.low = std::min(interval.low, is_logarithm ? std::exp(low) : low);
        interval.high = std::max(interval.high, is_logarithm ? std::exp(high) : high);
    };
    widen(measurement.passing, levels.of_passing());
    widen(measurement.failing, levels.of_failing());
}

Measurement measure_exactly(double value, const Band& band) {
    const stats::Interval point{.low = value, .high = value, .level = 1, .method = "exact", .n = 1};
    return {.value = value,
            .passing = point,
            .failing = point,
            .minimum_detectable = std::isfinite(band.high) ? band.high : band.low};
}

}  // namespace ff::studies::gates
