#include "studies/analysis/summary.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/goodness_of_fit/anderson_darling.hpp"
#include "stats/means/mean_interval.hpp"
#include "stats/variances/tails.hpp"
#include "stats/variances/variance_interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::studies {
namespace {

std::optional<double> mean_relative_error(std::span<const double> values, double reference) {
    if (reference == 0 || values.empty()) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += 100.0 * std::abs(value - reference) / reference;
    return sum / static_cast<double>(values.size());
}

void add_quantiles(std::span<const double> values, Summary& summary) {
    static constexpr std::array probabilities{0.0, 0.025, 0.05, 0.5, 0.95, 0.975, 1.0};
    const auto q = stats::quantiles(values, probabilities);
    summary.min = q[0];
    summary.q025 = q[1];
    summary.q05 = q[2];
    summary.median = q[3];
    summary.q95 = q[4];
    summary.q975 = q[5];
    summary.max = q[6];
}

/// The mean of the trials less `centre`: by hits where they are binomial, otherwise by the rule for means.
struct MeanOfTrials {
    std::optional<stats::Interval> interval;
    double caution = 0;  ///< how much skewness lengthens the reach of the family-wise test, in standard errors
    std::optional<double> spread;  ///< standard deviation of a trial, where it is known from the exact value
};

MeanOfTrials mean_about(double centre, std::span<const double> values, const SummaryRequest& request) {
    const auto hits = request.binomial ? binomial_hits(values, *request.lattice) : std::nullopt;
    if (hits) {
        const auto interval = stats::clopper_pearson_interval(*hits, request.level).shifted(-centre);
        const double p = request.reference.value_or(0);
        return {interval, 0, std::sqrt(p * (1 - p) * *request.lattice)};
    }
    if (request.variance != VarianceStatus::finite) return {};
    const auto mean = mean_of_trials(values, centre, request.pilot, request.limits);
    if (!mean) return {};
    const auto interval = stats::interval_of(*mean, request.level);
    if (!interval.is_finite()) return {};
    const double strict = stats::interval_of(*mean, 1 - request.pair_alpha).width() / (2 * mean->standard_error);
    return {interval, strict - stats::student_critical(mean->freedom, request.pair_alpha / 2), {}};
}

void add_mean(std::span<const double> values, const SummaryRequest& request, Summary& summary) {
    if (summary.trials < 2) return;
    const double centre = request.reference.value_or(values.front());
    const auto [interval, caution, known_spread] = mean_about(centre, values, request);
    if (!interval) return;
    summary.mean_interval = interval->shifted(centre);
    if (!request.reference) return;
    summary.bias_interval = interval;
    const auto pilot = request.pilot ? stats::pilot_of(values, *request.pilot) : std::nullopt;
    const double spread = pilot ? pilot->standard_deviation : known_spread.value_or(*summary.std);
    if (spread == 0) return;
    summary.bias_se = spread / std::sqrt(static_cast<double>(values.size()));
    if (request.detectable_bias <= 0) return;
    const double detectable = request.detectable_bias * spread + caution * *summary.bias_se;
    constexpr double largest_possible = 1;  // a form factor lies between 0 and 1
    const bool possible = detectable < largest_possible || request.quantity.kind != QuantityKind::form_factor;
    if (std::isfinite(detectable) && possible) summary.minimum_detectable_bias = detectable;
}

void add_spread(std::span<const double> values, const stats::Moments& moments, const SummaryRequest& request,
                Summary& summary) {
    summary.std = moments.standard_deviation();
    summary.skewness = moments.skewness();
    summary.excess_kurtosis = moments.excess_kurtosis();
    summary.vov = moments.variance_of_variance();
    if (const auto tail = stats::fit_tail(values)) summary.tail_index = tail->index();
    const bool constant = !summary.std || *summary.std == 0;
    if (!constant) {
        const auto jittered = request.lattice ? stats::jitter_lattice(values, *request.lattice, request.key)
                                              : std::vector<double>(values.begin(), values.end());
        if (const auto test = stats::test_normality(jittered)) summary.normality_p = test->p;
    }
    // A sample variance exists under infinite variance too, but says nothing: no interval, no standard error.
    if (request.variance == VarianceStatus::finite) {
        summary.std_interval = stats::standard_deviation_interval(values, request.level, {request.key});
        if (!constant && request.evaluations_per_face > 0) {
            summary.efficiency_samples =
                1.0 / (*summary.std * *summary.std * static_cast<double>(request.evaluations_per_face));
        }
    }
    add_mean(values, request, summary);
}

/// From here on (damaged stores contain such values) fourth powers are infinite, so that the value itself counts as
/// infinite.
constexpr double largest_value = 1e75;

constexpr std::size_t fewest_values = 20;
constexpr double fewest_bins = 8;
constexpr double most_bins = 40;
constexpr std::size_t most_quantiles = 41;

struct BinGrid {
    double low = 0;
    double width = 0;
    std::size_t bins = 0;
};

BinGrid grid_of(std::span<const double> ascending, double quartile_range, std::optional<double> lattice) {
    const double range = ascending.back() - ascending.front();
    const double rule = 2 * quartile_range / std::cbrt(static_cast<double>(ascending.size()));
    double width = std::clamp(rule, range / most_bins, range / fewest_bins);
    double low = ascending.front();
    if (lattice) {
        width = *lattice * std::max(1.0, std::round(width / *lattice));
        low -= *lattice / 2;
    }
    return {low, width, static_cast<std::size_t>(std::floor((ascending.back() - low) / width)) + 1};
}

}  // namespace

std::optional<stats::Proportion> binomial_hits(std::span<const double> values, double lattice) {
    constexpr double improbable = 1e-4;
    const double rays = std::round(1 / lattice);
    const double mean = *stats::moments_of(values).mean();
    const double variance = mean * (1 - mean) / rays;
    if (variance > 0) {
        const auto freedom = static_cast<double>(values.size() - 1);
        const double dispersion = *stats::moments_of(values, mean).variance() * freedom / variance;
        const double above = stats::chi_squared_tail(dispersion, freedom);
        if (std::min(above, 1 - above) < improbable / 2) return std::nullopt;
    }
    stats::Proportion counts;
    for (const double value : values) counts.hits += static_cast<std::uint64_t>(std::llround(value * rays));
    counts.trials = values.size() * static_cast<std::uint64_t>(rays);
    return counts;
}

std::optional<stats::MeanEvidence> mean_of_trials(std::span<const double> values, double reference,
                                                  std::optional<std::size_t> pilot_trials,
                                                  const stats::KnownLimits& limits) {
    if (!pilot_trials) return stats::mean_evidence(values, reference, limits);
    const auto pilot = stats::skewed_pilot_of(values, *pilot_trials, limits.largest_part);
    return pilot ? std::optional(stats::mean_evidence_after(*pilot, values, reference, limits)) : std::nullopt;
}

Summary summarise(std::span<const double> values, const SummaryRequest& request) {
    Summary summary;
    summary.quantity = request.quantity;
    summary.pair_class = request.pair_class;
    summary.variance = request.variance;
    summary.reference = request.reference;
    summary.trials = values.size();
    if (values.empty()) return summary;
    const auto finite = std::ranges::count_if(values, [](double value) { return std::abs(value) < largest_value; });
    summary.not_finite = values.size() - static_cast<std::size_t>(finite);
    if (summary.not_finite > 0) {
        // The remaining trials would only be those that happened to go well.
        summary.variance = VarianceStatus::undefined;
        return summary;
    }

    const auto moments = stats::moments_of(values, request.reference.value_or(values.front()));
    summary.mean = moments.mean();
    add_quantiles(values, summary);
    if (request.reference) {
        summary.bias = moments.bias();
        summary.rmse = moments.root_mean_squared_error();
        summary.median_abs_error = stats::median_absolute_error(values, *request.reference);
        summary.relative_error_percent = mean_relative_error(values, *request.reference);
    }
    if (request.variance != VarianceStatus::none) add_spread(values, moments, request, summary);
    return summary;
}

std::optional<ErrorShape> error_shape(std::span<const double> values, double reference, std::optional<double> lattice) {
    if (values.size() < fewest_values) return std::nullopt;
    std::vector<double> errors;
    for (const double value : values) errors.push_back(value - reference);
    std::ranges::sort(errors);
    const auto moments = stats::moments_of(errors, 0.0);
    ErrorShape shape;
    shape.mean = *moments.mean();
    shape.sigma = *moments.standard_deviation();
    if (!(shape.sigma > 0)) return std::nullopt;
    shape.q25 = stats::quantile(errors, 0.25);
    shape.q75 = stats::quantile(errors, 0.75);

    const BinGrid grid = grid_of(errors, shape.q75 - shape.q25, lattice);
    const auto count = static_cast<double>(errors.size());
    const auto above = [&](double edge) { return count * stats::normal_tail((edge - shape.mean) / shape.sigma); };
    for (std::size_t i = 0; i < grid.bins; ++i) {
        const double low = grid.low + grid.width * static_cast<double>(i);
        const double high = grid.low + grid.width * static_cast<double>(i + 1);
        shape.bins.push_back({low, high, 0, above(low) - above(high)});
    }
    for (const double error : errors) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, (error - grid.low) / grid.width));
        ++shape.bins[std::min(bin, grid.bins - 1)].runs;
    }

    const std::size_t quantiles = std::min(most_quantiles, errors.size());
    for (std::size_t k = 0; k < quantiles; ++k) {
        const double probability = (static_cast<double>(k) + 0.5) / static_cast<double>(quantiles);
        shape.quantiles.push_back({stats::normal_critical(1 - probability),
                                   (stats::quantile(errors, probability) - shape.mean) / shape.sigma});
    }
    return shape;
}

}  // namespace ff::studies
