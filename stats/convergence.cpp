#include "stats/convergence.hpp"

#include "core/contract.hpp"
#include "stats/quantiles.hpp"

#include <boost/math/special_functions/trigamma.hpp>

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

double mean_square(std::span<const double> errors) {
    double sum = 0;
    for (const double error : errors) sum += error * error;
    return sum / static_cast<double>(errors.size());
}

/// Fourth moment over squared second moment, about 0; 3 on average for normal errors whatever their number.
double kurtosis(std::span<const double> errors) {
    const double n = static_cast<double>(errors.size());
    const double scale = mean_square(errors);
    double sum = 0;
    for (const double error : errors) sum += error * error / scale * (error * error / scale);
    return sum / n * (n + 2) / n;
}

double kurtosis_factor(std::span<const Rung> ladder) {
    double sum = 0;
    for (const Rung& rung : ladder) sum += kurtosis(rung.errors);
    const double excess = sum / static_cast<double>(ladder.size()) - 3;
    return std::max(1.0, 1 + excess / 2);
}

double log_rmse(std::span<const double> errors) {
    return std::log(mean_square(errors)) / 2;
}

double log_median(std::span<const double> errors) {
    return std::log(*median_absolute_error(errors, 0));
}

using Summary = double (*)(std::span<const double>);

/// ln sizes, and a summary's logarithm at each.
struct LogLog {
    std::vector<double> x, y, variances;
};

LogLog log_log(std::span<const Rung> ladder, Summary summary, double factor) {
    LogLog points;
    for (const Rung& rung : ladder) {
        points.x.push_back(std::log(rung.size));
        points.y.push_back(summary(rung.errors));
        // ln RMSE is half of ln MSE.
        points.variances.push_back(factor * log_chi_squared_variance(static_cast<double>(rung.errors.size())) / 4);
    }
    return points;
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Slopes of ladders whose errors are drawn anew, with replacement, within each size.
std::vector<double> bootstrap_slopes(std::span<const Rung> ladder, Summary summary, LogLog points,
                                     const ResamplingPlan& plan) {
    std::vector<double> slopes;
    std::vector<double> sample;
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::bootstrap, replicate);
        for (std::size_t i = 0; i < ladder.size(); ++i) {
            sample.resize(ladder[i].errors.size());
            resample(ladder[i].errors, draws, sample);
            points.y[i] = summary(sample);
        }
        // A sample of exact zeros has no logarithm; it takes some errors to be exactly 0.
        if (all_finite(points.y)) slopes.push_back(fit_line(points.x, points.y, points.variances)->slope);
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
}

std::optional<ConvergenceRate> fit_rate(std::span<const Rung> ladder, Summary summary, double factor, double level,
                                        const ResamplingPlan& plan) {
    const LogLog points = log_log(ladder, summary, factor);
    if (!all_finite(points.y)) return std::nullopt;
    const auto line = fit_line(points.x, points.y, points.variances);
    if (!line) return std::nullopt;
    const std::vector<double> slopes = bootstrap_slopes(ladder, summary, points, plan);
    if (slopes.empty()) return std::nullopt;

    ConvergenceRate rate;
    rate.rate = line->slope;
    rate.interval = slope_interval_normal(*line, level);
    rate.bootstrap = {.low = quantile(slopes, (1 - level) / 2),
                      .high = quantile(slopes, (1 + level) / 2),
                      .level = level,
                      .method = "percentile_bootstrap",
                      .n = slopes.size()};
    rate.lack_of_fit_p = line->lack_of_fit_p;
    rate.kurtosis_factor = factor;
    rate.points = ladder.size();
    return rate;
}

bool has_replicates(std::span<const Rung> ladder) {
    return std::all_of(ladder.begin(), ladder.end(), [](const Rung& rung) { return rung.errors.size() >= 2; });
}

}  // namespace

std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    if (ladder.empty() || !has_replicates(ladder)) return std::nullopt;
    const bool some_exact =
        std::any_of(ladder.begin(), ladder.end(), [](const Rung& rung) { return mean_square(rung.errors) == 0; });
    if (some_exact) return std::nullopt;
    return fit_rate(ladder, log_rmse, kurtosis_factor(ladder), level, plan);
}

std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    if (ladder.empty() || !has_replicates(ladder)) return std::nullopt;
    auto rate = fit_rate(ladder, log_median, 1, level, plan);
    if (!rate) return std::nullopt;
    // The weights are right up to a common factor, so the line is; its interval and lack of fit are not.
    rate->interval = rate->bootstrap;
    rate->lack_of_fit_p.reset();
    return rate;
}

double log_chi_squared_variance(double freedom) {
    FF_EXPECT(freedom > 0);
    return boost::math::trigamma(freedom / 2);
}

}  // namespace ff::stats
