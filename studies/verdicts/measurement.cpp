#include "studies/verdicts/measurement.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/gates/skewed_reach.hpp"

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

/// The same for ratios.
double beyond_by_this_factor(const Band& band, double factor) {
    return std::isfinite(band.high) ? band.high * factor : band.low / factor;
}

/// A ratio that lies beyond the band by this factor fails with the power.
double beyond_by_factor(const Band& band, double log_standard_error, const Levels& levels) {
    return beyond_by_this_factor(band, std::exp(reach_to_fail(levels) * log_standard_error));
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

/// Below, normal approximations and a kurtosis mean little, and the far quantiles of t are very far.
constexpr std::uint64_t fewest_trials = 32;

/// Nobody runs more trials than this.
constexpr double most_trials = 1e15;

std::optional<std::uint64_t> whole(double trials) {
    if (!(trials <= most_trials)) return std::nullopt;
    return std::max(fewest_trials, static_cast<std::uint64_t>(std::ceil(trials)));
}

/// Chance that one comparison may miss at each end of its band.
double miss(const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(comparisons >= 1);
    return (1 - levels.power) / static_cast<double>(2 * comparisons);
}

/// Standard errors that have to fit between the middle and an end of the band.
double reach_to_pass(const Levels& levels, std::size_t comparisons) {
    return stats::normal_critical(levels.pass_alpha) + stats::normal_critical(miss(levels, comparisons));
}

/// The part of the half width of a band that the reference leaves; empty where nothing is left.
std::optional<double> room_beside(double half_width, double reference_se, double reach) {
    const double uncertain = reach * reference_se;
    if (uncertain >= half_width) return std::nullopt;
    return std::sqrt(half_width * half_width - uncertain * uncertain);
}

/// Number of trials relative to Student's t for an interval that allows for skewness, which normal values do not have.
double price_of_caution(const Levels& levels, std::size_t comparisons, std::uint64_t trials) {
    const auto n = static_cast<double>(std::max(trials, fewest_trials));
    const double t = stats::student_critical(n - 1, levels.pass_alpha);
    const double z = stats::normal_critical(levels.pass_alpha);
    const gate::MeanSkewness skewness{.error =
                                          *stats::skewness_standard_error(static_cast<std::size_t>(n)) / std::sqrt(n)};
    const double longer = gate::skewed_reach(skewness, 1, t, z) - t;
    return std::pow(1 + longer / reach_to_pass(levels, comparisons), 2);
}

}  // namespace

std::optional<Measurement> measure_mean(std::span<const double> values, const MeanReference& reference,
                                        const Band& band, const Levels& levels, const stats::KnownLimits& limits,
                                        const std::optional<stats::Autocorrelation>& correlation) {
    const auto own = stats::mean_evidence(values, reference.value, limits, correlation);
    if (!own) return std::nullopt;
    const auto mean =
        stats::with_uncertain_reference(*own, reference.standard_error, reference.freedom, reference.skewness);
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
    return measured_at(std::sqrt(spread.mean_square) / reference, levels, interval_of,
                       beyond_by_factor(band, std::sqrt(log_variance(spread)), levels));
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
    allow_for_skewness(measurement, logarithm, true, band, levels);
    return measurement;
}

Measurement measure_spread(const stats::MeanSquare& spread, const stats::MeanSquare& reference, const Band& band,
                           const Levels& levels) {
    const auto interval_of = [&](double level) { return stats::ratio_interval(spread, reference, level); };
    return measured_at(std::sqrt(spread.mean_square / reference.mean_square), levels, interval_of,
                       beyond_by_factor(band, std::sqrt(log_variance(spread) + log_variance(reference)), levels));
}

Measurement measure_proportion(const stats::Proportion& counts, const Band& band, const Levels& levels) {
    const auto interval_of = [&](double level) { return stats::clopper_pearson_interval(counts, level); };
    const auto deviation = [&](double p) { return std::sqrt(p * (1 - p) / static_cast<double>(counts.trials)); };
    // An upper end of 1 cannot be exceeded; then the lower one is looked beyond.
    const double detectable = band.high < 1 ? std::min(1.0, band.high + reach_to_fail(levels) * deviation(band.high))
                                            : std::max(0.0, band.low - reach_to_fail(levels) * deviation(band.low));
    return measured_at(counts.share(), levels, interval_of, detectable);
}

std::optional<Measurement> measure_slope(std::span<const stats::Rung> ladder, const Band& band, const Levels& levels) {
    // One resample is enough: the bootstrap interval does not reach the requested levels, and is not used.
    const auto fitted =
        stats::fit_rmse_rate(ladder, levels.of_failing(), stats::ResamplingPlan{.key = {}, .replicates = 1});
    if (!fitted) return std::nullopt;
    const double error = fitted->interval.width() / 2 / stats::normal_critical(levels.fail_alpha / 2);
    const auto interval_of = [&](double level) {
        return stats::interval_around(fitted->rate, stats::normal_critical((1 - level) / 2) * error, level,
                                      fitted->interval.method, fitted->interval.n);
    };
    return measured_at(fitted->rate, levels, interval_of, beyond(band, reach_to_fail(levels) * error));
}

void allow_for_skewness(Measurement& measurement, const stats::Measured& number, bool is_logarithm, const Band& band,
                        const Levels& levels) {
    const auto widen = [&](stats::Interval& interval, double level) {
        const double low = number.value - number.reach(-1, (1 - level) / 2);
        const double high = number.value + number.reach(1, (1 - level) / 2);
        interval.low = std::min(interval.low, is_logarithm ? std::exp(low) : low);
        interval.high = std::max(interval.high, is_logarithm ? std::exp(high) : high);
    };
    widen(measurement.passing, levels.of_passing());
    widen(measurement.failing, levels.of_failing());
    // An effect is noticed where the failing interval around what is measured of it leaves the band, its own error
    // included.
    const bool is_above = std::isfinite(band.high);
    const double end = is_above ? measurement.failing.low : measurement.failing.high;
    const double error = stats::normal_critical(1 - levels.power) * number.standard_error();
    const double reach = error + std::abs(is_logarithm ? std::log(end / measurement.value) : end - measurement.value);
    const double noticed = is_logarithm ? beyond_by_this_factor(band, std::exp(reach)) : beyond(band, reach);
    double& detectable = measurement.minimum_detectable;
    detectable = is_above ? std::max(detectable, noticed) : std::min(detectable, noticed);
}

Measurement measure_exactly(double value, const Band& band) {
    const stats::Interval point{.low = value, .high = value, .level = 1, .method = "exact", .n = 1};
    return {.value = value,
            .passing = point,
            .failing = point,
            .minimum_detectable = std::isfinite(band.high) ? band.high : band.low};
}

bool can_decide_mean(double half_width, double sigma, double reference_se, const Levels& levels,
                     std::size_t comparisons) {
    FF_EXPECT(half_width > 0 && sigma >= 0);
    const auto room = room_beside(half_width, reference_se, reach_to_pass(levels, comparisons));
    return room && reach_to_pass(levels, comparisons) * sigma <= *room * std::sqrt(most_trials);
}

std::optional<std::uint64_t> trials_for_mean(double half_width, double sigma, double skewness, double reference_se,
                                             const Levels& levels, std::size_t comparisons) {
    if (!can_decide_mean(half_width, sigma, reference_se, levels, comparisons)) return std::nullopt;
    const double room = room_beside(half_width, reference_se, reach_to_pass(levels, comparisons)).value();
    const double z = stats::normal_critical(levels.fail_alpha / 2);
    const double straight = std::pow(z * z * z * skewness / (3 * std::log(2.0)), 2);
    const auto enough = whole(straight);
    if (!enough || sigma == 0) return enough;
    const auto trials = static_cast<std::uint64_t>(
        stats::trials_for_equivalence(room, sigma, {levels.pass_alpha, levels.power}, comparisons));
    return whole(static_cast<double>(std::max(*enough, trials)) * price_of_caution(levels, comparisons, trials));
}

std::optional<std::uint64_t> runs_for_mean(double half_width, double error, double reference_se, const Levels& levels,
                                           std::size_t comparisons) {
    if (!can_decide_mean(half_width, error, reference_se, levels, comparisons)) return std::nullopt;
    const double reach = reach_to_pass(levels, comparisons);
    const double runs = std::pow(reach * error / room_beside(half_width, reference_se, reach).value(), 2);
    return std::max(std::uint64_t{1}, static_cast<std::uint64_t>(std::ceil(runs)));
}

std::optional<std::uint64_t> trials_for_ratio(const Band& band, double excess_kurtosis, double reference_freedom,
                                              const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(band.low < 1 && band.high > 1);
    const double half_width = std::min(-std::log(band.low), std::log(band.high));
    const double z = reach_to_pass(levels, comparisons);
    // ln of a standard deviation has the variance 1 / (2 freedom); chi-squared is skewed, which costs half a z^2 more.
    const double freedom = z * z / 2 / (half_width * half_width - z * z / (2 * reference_freedom)) + z * z / 2;
    if (half_width * half_width <= z * z / (2 * reference_freedom)) return std::nullopt;
    return whole(freedom * (1 + std::max(0.0, excess_kurtosis) / 2) + 1);
}

std::optional<std::uint64_t> trials_for_proportion(const Band& band, double probability, const Levels& levels,
                                                   std::size_t comparisons) {
    const double below = probability - band.low;
    const double above = band.high < 1 ? band.high - probability : below;
    if (!(below > 0 && above > 0)) return std::nullopt;
    // Wide enough at the end of the band as well as at the truth; Clopper-Pearson adds a count.
    const auto needed = [&](double room, double end) {
        const auto deviation = [](double p) { return std::sqrt(p * (1 - p)); };
        const double width = stats::normal_critical(levels.pass_alpha) * deviation(end) +
                             stats::normal_critical(miss(levels, comparisons)) * deviation(probability);
        return width * width / (room * room) + 2 / room;
    };
    const double upper = band.high < 1 ? needed(above, band.high) : 0;
    return whole(std::max(needed(below, std::max(0.0, band.low)), upper));
}

std::optional<std::uint64_t> trials_for_slope(const Band& band, std::span<const double> sizes, double kurtosis_factor,
                                              const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(band.low < band.high && sizes.size() >= 2);
    double mean = 0;
    for (const double size : sizes) mean += std::log(size) / static_cast<double>(sizes.size());
    double spread = 0;
    for (const double size : sizes) spread += std::pow(std::log(size) - mean, 2);
    const double error = (band.high - band.low) / 2 / reach_to_pass(levels, comparisons);
    // Var(slope) = Var(ln RMSE) / spread, Var(ln RMSE) about factor / (2 T).
    return whole(kurtosis_factor / (2 * spread * error * error));
}

double rays_for_loss(double rate, const Levels& levels) {
    FF_EXPECT(0 < rate && rate < 1);
    return std::ceil(std::log1p(-levels.power) / std::log1p(-rate));
}

}  // namespace ff::studies::gates
