#include "studies/analysis/summary.hpp"

#include "stats/mean_interval.hpp"
#include "stats/moments.hpp"
#include "stats/normality.hpp"
#include "stats/quantiles.hpp"
#include "stats/tail_index.hpp"
#include "stats/two_stage.hpp"
#include "stats/variance_interval.hpp"

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

void add_spread(std::span<const double> values, const stats::Moments& moments, const SummaryRequest& request,
                Summary& summary) {
    summary.std = moments.standard_deviation();
    summary.skewness = moments.skewness();
    summary.excess_kurtosis = moments.excess_kurtosis();
    summary.vov = moments.variance_of_variance();
    if (const auto tail = stats::fit_tail(values)) summary.tail_index = tail->index;
    const bool constant = !summary.std || *summary.std == 0;
    if (!constant) {
        const auto jittered = request.lattice ? stats::jitter_lattice(values, *request.lattice, request.key)
                                              : std::vector<double>(values.begin(), values.end());
        if (const auto test = stats::test_normality(jittered)) summary.normality_p = test->p;
    }
    // A sample variance exists under infinite variance too, but says nothing: no interval, no standard error.
    if (request.variance != VarianceStatus::finite) return;
    summary.std_interval = stats::standard_deviation_interval(values, request.level, {request.key});
    if (constant) return;
    if (request.evaluations_per_face > 0) {
        summary.efficiency_samples =
            1.0 / (*summary.std * *summary.std * static_cast<double>(request.evaluations_per_face));
    }
    const auto pilot = request.pilot ? stats::pilot_of(values, *request.pilot) : std::nullopt;
    const auto about_centre = pilot ? stats::bias_interval_two_stage(moments, *pilot, request.level)
                                    : stats::bias_interval_t(moments, request.level);
    if ((summary.mean_interval = about_centre)) {
        const double centre = request.reference.value_or(values.front());
        summary.mean_interval->low += centre;
        summary.mean_interval->high += centre;
    }
    if (!request.reference) return;
    summary.bias_interval = about_centre;
    const double spread = pilot ? pilot->standard_deviation : *summary.std;
    summary.bias_se = pilot ? spread / std::sqrt(static_cast<double>(values.size())) : moments.standard_error();
    const double detectable = request.detectable_bias * spread;
    constexpr double largest_possible = 1;  // a form factor lies between 0 and 1
    if (detectable > 0 && (detectable < largest_possible || request.quantity.kind != QuantityKind::form_factor))
        summary.minimum_detectable_bias = detectable;
}

/// From here up (damaged stores hold such values) fourth powers are infinite: a value counts as infinite itself.
constexpr double largest_value = 1e75;

}  // namespace

Summary summarise(std::span<const double> values, const SummaryRequest& request) {
    Summary summary;
    summary.quantity = request.quantity;
    summary.pair_class = request.pair_class;
    summary.variance = request.variance;
    summary.reference = request.reference;
    summary.trials = values.size();
    if (values.empty()) return summary;
    const auto finite =
        std::count_if(values.begin(), values.end(), [](double value) { return std::abs(value) < largest_value; });
    summary.not_finite = values.size() - static_cast<std::size_t>(finite);
    if (summary.not_finite > 0) {
        // The others alone would be the trials that happened to go well.
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

}  // namespace ff::studies
