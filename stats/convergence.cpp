#include "stats/convergence.hpp"

#include "core/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/moments.hpp"
#include "stats/quantiles.hpp"

#include <boost/math/special_functions/trigamma.hpp>

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// How often each replicate of a rung was drawn.
using Draw = std::vector<std::size_t>;

/// The root mean squared error of a rung, for any draw of its replicates.
class LogRmse {
  public:
    explicit LogRmse(const Rung& rung) : mean_squares_(rung.replicates(), 0.0) {
        const double width = static_cast<double>(rung.width);
        for (std::size_t i = 0; i < rung.errors.size(); ++i)
            mean_squares_[i / rung.width] += rung.errors[i] * rung.errors[i] / width;
    }

    [[nodiscard]] double operator()(const Draw& draw) const {
        double sum = 0;
        for (std::size_t i = 0; i < draw.size(); ++i) sum += static_cast<double>(draw[i]) * mean_squares_[i];
        return std::log(sum / static_cast<double>(draw.size())) / 2;
    }

    [[nodiscard]] std::span<const double> mean_squares() const { return mean_squares_; }

  private:
    std::vector<double> mean_squares_;
};

/// The median absolute error of a rung, for any draw of its replicates: sorted once, then counted.
class LogMedian {
  public:
    explicit LogMedian(const Rung& rung) {
        for (std::size_t i = 0; i < rung.errors.size(); ++i)
            errors_.push_back({std::abs(rung.errors[i]), i / rung.width});
        std::sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) { return a.size < b.size; });
    }

    [[nodiscard]] double operator()(const Draw& draw) const {
        const std::size_t upper = errors_.size() / 2;  // the middle, or the upper of the two in the middle
        const std::size_t lower = (errors_.size() - 1) / 2;
        double below = 0;
        std::size_t counted = 0;
        for (const Error& error : errors_) {
            const std::size_t before = counted;
            counted += draw[error.replicate];
            if (before <= lower && lower < counted) below = error.size;
            if (upper < counted) return std::log((below + error.size) / 2);
        }
        return std::log(0.0);
    }

  private:
    struct Error {
        double size = 0;
        std::size_t replicate = 0;
    };
    std::vector<Error> errors_;
};

/// Squared relative variation of the replicates' mean squared errors, over 2: 1 for one normal error a replicate.
double variance_factor(std::span<const LogRmse> rungs, std::size_t width) {
    const double normal = 2 / static_cast<double>(width);  // squared relative variation for independent normal errors
    double sum = 0;
    for (const LogRmse& rung : rungs) {
        const auto squares = rung.mean_squares();
        const double n = static_cast<double>(squares.size());
        double mean = 0;
        for (const double square : squares) mean += square / n;
        double ratio = 0;
        for (const double square : squares) ratio += square / mean * (square / mean) / n;
        sum += ratio * (n + normal) / n - 1;  // exact on average for normal errors, whatever their number
    }
    return std::max(normal, sum / static_cast<double>(rungs.size())) / 2;
}

/// ln sizes, and a summary's logarithm at each.
struct LogLog {
    std::vector<double> x, y, variances;
};

template <class Summary>
LogLog log_log(std::span<const Rung> ladder, std::span<const Summary> summaries, double factor) {
    LogLog points;
    for (std::size_t i = 0; i < ladder.size(); ++i) {
        const std::size_t replicates = ladder[i].replicates();
        points.x.push_back(std::log(ladder[i].size));
        points.y.push_back(summaries[i](Draw(replicates, 1)));
        // ln RMSE is half of ln MSE.
        points.variances.push_back(factor * log_chi_squared_variance(static_cast<double>(replicates)) / 4);
    }
    return points;
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Slopes of ladders whose replicates are drawn anew, with replacement, within each size.
template <class Summary>
std::vector<double> bootstrap_slopes(std::span<const Rung> ladder, std::span<const Summary> summaries, LogLog points,
                                     const ResamplingPlan& plan) {
    std::vector<double> slopes;
    Draw draw;
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::bootstrap, replicate);
        for (std::size_t i = 0; i < ladder.size(); ++i) {
            draw.assign(ladder[i].replicates(), 0);
            for (std::size_t n = 0; n < draw.size(); ++n) ++draw[draws.below(draw.size())];
            points.y[i] = summaries[i](draw);
        }
        // A sample of exact zeros has no logarithm; it takes some errors to be exactly 0.
        if (all_finite(points.y)) slopes.push_back(fit_line(points.x, points.y, points.variances)->slope);
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
}

template <class Summary>
std::optional<ConvergenceRate> fit_rate(std::span<const Rung> ladder, std::span<const Summary> summaries, double factor,
                                        double level, const ResamplingPlan& plan) {
    const LogLog points = log_log(ladder, summaries, factor);
    if (!all_finite(points.y)) return std::nullopt;
    const auto line = fit_line(points.x, points.y, points.variances);
    if (!line) return std::nullopt;
    const std::vector<double> slopes = bootstrap_slopes(ladder, summaries, points, plan);
    if (slopes.empty()) return std::nullopt;

    ConvergenceRate rate;
    rate.rate = line->slope;
    rate.interval = slope_interval_normal(*line, level);
    rate.bootstrap = {.low = quantile(slopes, (1 - level) / 2),
                      .high = quantile(slopes, (1 + level) / 2),
                      .level = level,
                      .method = "percentile_bootstrap",
                      .n = slopes.size()};
    rate.standard_error = moments_of(slopes).standard_deviation().value_or(0.0);
    rate.lack_of_fit_p = line->lack_of_fit_p;
    rate.variance_factor = factor;
    rate.points = ladder.size();
    return rate;
}

bool has_replicates(std::span<const Rung> ladder) {
    return !ladder.empty() &&
           std::all_of(ladder.begin(), ladder.end(), [](const Rung& rung) { return rung.replicates() >= 2; });
}

}  // namespace

std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    if (!has_replicates(ladder)) return std::nullopt;
    const auto exact = [](const Rung& rung) {
        return std::all_of(rung.errors.begin(), rung.errors.end(), [](double error) { return error == 0; });
    };
    if (std::any_of(ladder.begin(), ladder.end(), exact)) return std::nullopt;
    const std::vector<LogRmse> summaries(ladder.begin(), ladder.end());
    const double factor = variance_factor(summaries, ladder.front().width);
    auto rate = fit_rate<LogRmse>(ladder, summaries, factor, level, plan);
    if (rate) {
        const double reach = rate->interval.width() / 2 / normal_critical((1 - level) / 2);
        rate->standard_error = std::max(rate->standard_error, reach);
    }
    return rate;
}

std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    if (!has_replicates(ladder)) return std::nullopt;
    const std::vector<LogMedian> summaries(ladder.begin(), ladder.end());
    auto rate = fit_rate<LogMedian>(ladder, summaries, 1, level, plan);
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
