#include "stats/convergence/convergence.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <boost/math/special_functions/trigamma.hpp>

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// How often each block of a rung's replicates was drawn (LadderDraws).
using Draw = std::span<const std::uint32_t>;

/// Replicates of each block.
std::vector<std::size_t> block_sizes(const Rung& rung, std::size_t block) {
    std::vector<std::size_t> sizes(rung.replicates() / block, block);
    if (const std::size_t left = rung.replicates() % block; left > 0) sizes.push_back(left);
    return sizes;
}

std::size_t replicates_of(Draw draw, std::span<const std::size_t> sizes) {
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < draw.size(); ++i) drawn += draw[i] * sizes[i];
    return drawn;
}

/// The mean squared error of each replicate.
std::vector<double> mean_squares_of(const Rung& rung) {
    std::vector<double> mean_squares(rung.replicates(), 0.0);
    for (std::size_t i = 0; i < rung.errors.size(); ++i)
        mean_squares[i / rung.width] += rung.errors[i] * rung.errors[i] / static_cast<double>(rung.width);
    return mean_squares;
}

/// The root mean squared error of a rung, for any draw of its replicates.
class LogRmse {
  public:
    LogRmse(const Rung& rung, std::size_t block)
        : mean_squares_(mean_squares_of(rung)), sizes_(block_sizes(rung, block)), sums_(sizes_.size(), 0.0) {
        for (std::size_t i = 0; i < mean_squares_.size(); ++i) sums_[i / block] += mean_squares_[i];
    }

    [[nodiscard]] double operator()(Draw draw) const {
        double sum = 0;
        for (std::size_t i = 0; i < draw.size(); ++i) sum += static_cast<double>(draw[i]) * sums_[i];
        return std::log(sum / static_cast<double>(replicates_of(draw, sizes_))) / 2;
    }

    [[nodiscard]] std::span<const double> mean_squares() const { return mean_squares_; }
    [[nodiscard]] std::size_t blocks() const { return sizes_.size(); }

  private:
    std::vector<double> mean_squares_;  // one for each replicate
    std::vector<std::size_t> sizes_;
    std::vector<double> sums_;  // sums of mean squares, one for each block
};

/// The median absolute error of a rung, for any draw of its replicates: sorted once, then counted.
class LogMedian {
  public:
    LogMedian(const Rung& rung, std::size_t block) : width_(rung.width), sizes_(block_sizes(rung, block)) {
        for (std::size_t i = 0; i < rung.errors.size(); ++i)
            errors_.push_back({std::abs(rung.errors[i]), i / rung.width / block});
        std::sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) { return a.size < b.size; });
    }

    [[nodiscard]] double operator()(Draw draw) const {
        const std::size_t drawn = width_ * replicates_of(draw, sizes_);
        const std::size_t upper = drawn / 2;  // the middle, or the upper of the two in the middle
        const std::size_t lower = (drawn - 1) / 2;
        double below = 0;
        std::size_t counted = 0;
        for (const Error& error : errors_) {
            const std::size_t before = counted;
            counted += draw[error.block];
            if (before <= lower && lower < counted) below = error.size;
            if (upper < counted) return std::log((below + error.size) / 2);
        }
        return std::log(0.0);
    }

    [[nodiscard]] std::size_t blocks() const { return sizes_.size(); }

  private:
    struct Error {
        double size = 0;
        std::size_t block = 0;
    };
    std::size_t width_;
    std::vector<std::size_t> sizes_;
    std::vector<Error> errors_;
};

template <class Summary>
std::vector<Summary> summaries_of(std::span<const Rung> ladder, const LadderDraws& draws) {
    std::vector<Summary> summaries;
    for (std::size_t i = 0; i < ladder.size(); ++i) summaries.emplace_back(ladder[i], draws.block(i));
    return summaries;
}

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
        points.y.push_back(summaries[i](std::vector<std::uint32_t>(summaries[i].blocks(), 1)));
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
std::vector<double> bootstrap_slopes(std::span<const Summary> summaries, LogLog points, const LadderDraws& draws) {
    std::vector<double> slopes;
    for (std::size_t resample = 0; resample < draws.resamples(); ++resample) {
        for (std::size_t i = 0; i < summaries.size(); ++i) points.y[i] = summaries[i](draws.counts(resample, i));
        // A sample of exact zeros has no logarithm; it takes some errors to be exactly 0.
        if (all_finite(points.y)) slopes.push_back(fit_line(points.x, points.y, points.variances)->slope);
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
}

template <class Summary>
std::optional<ConvergenceRate> fit_rate(std::span<const Rung> ladder, std::span<const Summary> summaries, double factor,
                                        double level, const LadderDraws& draws) {
    const LogLog points = log_log(ladder, summaries, factor);
    if (!all_finite(points.y)) return std::nullopt;
    const auto line = fit_line(points.x, points.y, points.variances);
    if (!line) return std::nullopt;
    const std::vector<double> slopes = bootstrap_slopes(summaries, points, draws);
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
    if (line->freedom > 0)
        rate.misfit = std::sqrt(std::max(1.0, line->chi_squared / static_cast<double>(line->freedom)));
    rate.points = ladder.size();
    return rate;
}

LadderDraws draw(std::span<const Rung> ladder, const ResamplingPlan& plan) {
    std::vector<std::size_t> replicates;
    for (const Rung& rung : ladder) replicates.push_back(rung.replicates());
    return {replicates, plan};
}

bool has_replicates(std::span<const Rung> ladder) {
    return !ladder.empty() &&
           std::all_of(ladder.begin(), ladder.end(), [](const Rung& rung) { return rung.replicates() >= 2; });
}

}  // namespace

LadderDraws::LadderDraws(std::span<const std::size_t> replicates, const ResamplingPlan& plan)
    : resamples_(plan.replicates) {
    for (const std::size_t n : replicates) {
        const std::size_t block = std::max<std::size_t>(1, (n + most_blocks - 1) / most_blocks);
        const std::size_t blocks = (n + block - 1) / block;
        rungs_.push_back({.block = block, .blocks = blocks, .begin = width_});
        width_ += blocks;
    }
    counts_.assign(resamples_ * width_, 0);
    for (std::uint32_t resample = 0; resample < plan.replicates; ++resample) {
        Draws draws(plan.key, Resampling::bootstrap, resample);
        for (const RungBlocks& rung : rungs_) {
            const std::span<std::uint32_t> counts(counts_.data() + resample * width_ + rung.begin, rung.blocks);
            for (std::size_t n = 0; n < rung.blocks; ++n) ++counts[draws.below(rung.blocks)];
        }
    }
}

std::span<const std::uint32_t> LadderDraws::counts(std::size_t resample, std::size_t rung) const {
    return {counts_.data() + resample * width_ + rungs_[rung].begin, rungs_[rung].blocks};
}

std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const LadderDraws& draws) {
    if (!has_replicates(ladder)) return std::nullopt;
    const auto exact = [](const Rung& rung) {
        return std::all_of(rung.errors.begin(), rung.errors.end(), [](double error) { return error == 0; });
    };
    if (std::any_of(ladder.begin(), ladder.end(), exact)) return std::nullopt;
    const auto summaries = summaries_of<LogRmse>(ladder, draws);
    const double factor = variance_factor(summaries, ladder.front().width);
    auto rate = fit_rate<LogRmse>(ladder, summaries, factor, level, draws);
    if (rate) {
        const double reach = rate->interval.width() / 2 / normal_critical((1 - level) / 2);
        rate->standard_error = std::max(rate->standard_error, reach);
    }
    return rate;
}

std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const LadderDraws& draws) {
    if (!has_replicates(ladder)) return std::nullopt;
    const auto summaries = summaries_of<LogMedian>(ladder, draws);
    auto rate = fit_rate<LogMedian>(ladder, summaries, 1, level, draws);
    if (!rate) return std::nullopt;
    // The weights are right up to a common factor, so the line is; its interval and lack of fit are not.
    rate->interval = rate->bootstrap;
    rate->lack_of_fit_p.reset();
    rate->misfit = 1;
    return rate;
}

std::optional<ConvergenceRate> fit_rmse_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    return fit_rmse_rate(ladder, level, draw(ladder, plan));
}

std::optional<ConvergenceRate> fit_median_rate(std::span<const Rung> ladder, double level, const ResamplingPlan& plan) {
    return fit_median_rate(ladder, level, draw(ladder, plan));
}

namespace {

/// The logarithm of the mean square of each size; empty where one has too few replicates or no error.
std::optional<std::vector<MeanEvidence>> evidence_of(std::span<const Rung> ladder, std::span<const Unmet> unmet) {
    FF_EXPECT(unmet.size() == ladder.size());
    std::vector<MeanEvidence> means;
    for (std::size_t i = 0; i < ladder.size(); ++i) {
        auto mean = mean_evidence(mean_squares_of(ladder[i]), 0);
        if (!mean || mean->difference <= 0) return std::nullopt;
        mean->unmet = unmet[i];
        means.push_back(*mean);
    }
    return means;
}

/// A line through the sizes of a ladder, but perhaps one: how much each of them weighs in it.
struct LineWeights {
    std::vector<double> weights;  ///< 1 / variance; 0 for the size that is left out
    double sum = 0;
    double middle = 0;
    double squares = 0;

    LineWeights(std::span<const Rung> ladder, std::optional<std::size_t> left_out) {
        for (std::size_t i = 0; i < ladder.size(); ++i) {
            const double variance = log_chi_squared_variance(static_cast<double>(ladder[i].replicates()));
            weights.push_back(i == left_out ? 0 : 1 / variance);
            sum += weights.back();
            middle += weights.back() * std::log(ladder[i].size);
        }
        middle /= sum;
        for (std::size_t i = 0; i < ladder.size(); ++i)
            squares += weights[i] * std::pow(std::log(ladder[i].size) - middle, 2);
    }

    [[nodiscard]] double in_slope(std::size_t i, double size) const {
        return weights[i] * (std::log(size) - middle) / squares;
    }
    [[nodiscard]] double in_value_at(double x, std::size_t i, double size) const {
        return weights[i] / sum + (x - middle) * in_slope(i, size);
    }
};

/// Half the sum of the logarithms of mean squares with these weights, those of root mean squares.
Measured sum_of_logarithms(const std::vector<MeanEvidence>& means, const std::vector<double>& weights) {
    Measured sum;
    for (std::size_t i = 0; i < means.size(); ++i) {
        const double weight = weights[i] / 2;
        if (weight == 0) continue;
        sum.value += weight * std::log(means[i].difference);
        sum.parts.push_back({.mean = means[i], .weight = weight, .logarithm = true});
    }
    return sum;
}

}  // namespace

std::optional<Measured> measured_rmse_rate(std::span<const Rung> ladder, std::span<const Unmet> unmet) {
    if (ladder.size() < 2) return std::nullopt;
    const auto means = evidence_of(ladder, unmet);
    if (!means) return std::nullopt;
    const LineWeights line(ladder, std::nullopt);
    std::vector<double> weights;
    for (std::size_t i = 0; i < ladder.size(); ++i) weights.push_back(line.in_slope(i, ladder[i].size));
    return sum_of_logarithms(*means, weights);
}

double p_of_straight_line(std::span<const Rung> ladder, std::span<const Unmet> unmet) {
    const auto means = evidence_of(ladder, unmet);
    if (!means || ladder.size() < 3) return 1;
    double least = 1;
    for (std::size_t one = 0; one < ladder.size(); ++one) {
        const LineWeights others(ladder, one);
        std::vector<double> weights;
        for (std::size_t i = 0; i < ladder.size(); ++i)
            weights.push_back(i == one ? 1 : -others.in_value_at(std::log(ladder[one].size), i, ladder[i].size));
        least = std::min(least, p_of_equal(Measured{}, sum_of_logarithms(*means, weights)));
    }
    return std::min(1.0, least * static_cast<double>(ladder.size()));
}

double log_chi_squared_variance(double freedom) {
    FF_EXPECT(freedom > 0);
    return boost::math::trigamma(freedom / 2);
}

}  // namespace ff::stats
