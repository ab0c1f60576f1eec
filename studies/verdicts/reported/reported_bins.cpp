#include "studies/verdicts/reported/reported_bins.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ff::studies::gates {
namespace {

/// Student's t differs from here on from the normal distribution by less than 4e-4 of any p-value above 1e-10.
constexpr double normal_freedom = 1e6;

double tail_beyond(double t, double freedom) {
    return freedom >= normal_freedom ? stats::normal_tail(t) : stats::student_tail(t, freedom);
}

double critical(double freedom, double tail) {
    return freedom >= normal_freedom ? stats::normal_critical(tail) : stats::student_critical(freedom, tail);
}

/// Ratio of variances for the ratio of the scale.
double as_variances(double ratio, EffectScale scale) {
    return scale == EffectScale::ratio_of_deviations ? ratio * ratio : ratio;
}

double as_effect(double ratio_of_variances, EffectScale scale) {
    return scale == EffectScale::ratio_of_deviations ? std::sqrt(ratio_of_variances) : ratio_of_variances;
}

/// P-value of "the true ratio is at most `end`", against a ratio above it.
double p_above(const BinEffect& bin, EffectScale scale, double end) {
    return stats::fisher_tail(as_variances(bin.value, scale) / as_variances(end, scale), bin.freedom,
                              bin.freedom_below);
}

/// P-value of "the true ratio is at least `end`", against a ratio below it: the tail of the inverse ratio.
double p_below(const BinEffect& bin, EffectScale scale, double end) {
    if (end <= 0) return 0;
    return stats::fisher_tail(as_variances(end, scale) / as_variances(bin.value, scale), bin.freedom_below,
                              bin.freedom);
}

/// The least and the greatest of Student's critical values of all bins. Most effects lie outside this range, so that no
/// tail has to be computed for them.
struct Reach {
    double shortest = 0;
    double longest = 0;
};

Reach reach_of(const BinEffects& effects, double tail) {
    if (effects.scale != EffectScale::difference) return {};
    const auto [least, most] =
        std::minmax_element(effects.bins.begin(), effects.bins.end(),
                            [](const BinEffect& a, const BinEffect& b) { return a.freedom < b.freedom; });
    return {critical(most->freedom, tail), critical(least->freedom, tail)};
}

/// Whether the passing interval lies inside the band: both one-sided tests reject "at an end or beyond".
bool is_inside(const BinEffects& effects, std::size_t index, double pass_alpha, const Reach& reach) {
    const BinEffect& bin = effects.bins[index];
    const EffectScale scale = effects.scale;
    if (!(bin.band.low < bin.value && bin.value < bin.band.high) || bin.freedom == 0) return false;
    if (scale == EffectScale::difference_of_shares) {
        const auto& [counts, reference] = effects.shares[index];
        const stats::Interval passing = stats::share_difference_interval(counts, reference, 1 - 2 * pass_alpha);
        return bin.band.low < passing.low && passing.high < bin.band.high;
    }
    if (!effects.means.empty()) {
        const stats::Interval passing = stats::interval_of(effects.means[index], 1 - 2 * pass_alpha);
        return bin.band.low < passing.low && passing.high < bin.band.high;
    }
    if (scale != EffectScale::difference) {
        const bool under = std::isinf(bin.band.high) || p_below(bin, scale, bin.band.high) <= pass_alpha;
        return under && p_above(bin, scale, bin.band.low) <= pass_alpha;
    }
    const double room = std::min(bin.band.high - bin.value, bin.value - bin.band.low) / bin.error;
    if (room < reach.shortest || room >= reach.longest) return room >= reach.longest;
    return tail_beyond(room, bin.freedom) <= pass_alpha;
}

/// How far beyond the band, in standard errors; negative inside.
double errors_beyond_band(const BinEffect& bin) {
    const double outside = std::max(bin.value - bin.band.high, bin.band.low - bin.value);
    return bin.error > 0 ? outside / bin.error : outside;
}

}  // namespace

double p_value(const BinEffects& effects, std::size_t index) {
    const BinEffect& bin = effects.bins[index];
    if (bin.band.holds(bin.value) || bin.freedom == 0) return 1;
    const bool above = bin.value > bin.band.high;
    if (!effects.means.empty()) {
        stats::MeanEvidence beyond = effects.means[index];
        beyond.difference = bin.value - (above ? bin.band.high : bin.band.low);
        return stats::test_mean(beyond).p;
    }
    double one_sided = 0;
    switch (effects.scale) {
        case EffectScale::difference:
            one_sided = tail_beyond(errors_beyond_band(bin), bin.freedom);
            break;
        case EffectScale::difference_of_shares: {
            const auto& [counts, reference] = effects.shares[index];
            one_sided = above ? stats::p_of_at_most(counts, reference, bin.band.high)
                              : stats::p_of_at_least(counts, reference, bin.band.low);
            break;
        }
        default:
            one_sided = above ? p_above(bin, effects.scale, bin.band.high) : p_below(bin, effects.scale, bin.band.low);
    }
    return std::min(1.0, 2 * one_sided);
}

Measurement measure_bin(const BinEffects& effects, std::size_t index, const Levels& levels) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const BinEffect& bin = effects.bins[index];
    if (bin.freedom == 0) {
        const stats::Interval any{.low = 0, .high = infinity, .level = 1, .method = "unknown_kurtosis", .n = 0};
        return {.value = bin.value, .passing = any, .failing = any, .minimum_detectable = infinity};
    }
    const EffectScale scale = effects.scale;
    const auto n = static_cast<std::size_t>(std::isfinite(bin.freedom) ? bin.freedom + 1 : 0);
    const auto interval_at = [&](double level) {
        const double tail = (1 - level) / 2;
        if (scale == EffectScale::difference_of_shares)
            return stats::share_difference_interval(effects.shares[index].counts, effects.shares[index].reference,
                                                    level);
        if (!effects.means.empty()) return stats::interval_of(effects.means[index], level);
        stats::Interval interval;
        interval.level = level;
        interval.n = n;
        if (scale == EffectScale::difference) {
            const double half = critical(bin.freedom, tail) * bin.error;
            interval.low = bin.value - half;
            interval.high = bin.value + half;
            interval.method = std::isfinite(bin.freedom) ? "student_t" : "normal";
        } else {
            const double ratio = as_variances(bin.value, scale);
            interval.low = as_effect(ratio / stats::fisher_critical(tail, bin.freedom, bin.freedom_below), scale);
            interval.high = as_effect(ratio * stats::fisher_critical(tail, bin.freedom_below, bin.freedom), scale);
            interval.method = "fisher_f";
        }
        return interval;
    };
    Measurement m = measured_at(bin.value, levels, interval_at);
    const bool upwards = std::isfinite(bin.band.high);
    const double power = stats::normal_critical(1 - levels.power);
    if (scale == EffectScale::difference && effects.means.empty()) {
        const double reach = critical(std::max(1.0, bin.freedom), levels.fail_alpha / 2) + power;
        m.minimum_detectable = bin.band.high + reach * bin.error;
    } else if (effects.are_differences()) {
        m.minimum_detectable = bin.band.high + (bin.value - m.failing.low) + power * bin.error;
    } else {
        const double log_error = std::sqrt(2 / bin.freedom + 2 / bin.freedom_below);
        const double factor =
            as_effect(std::exp((stats::normal_critical(levels.fail_alpha / 2) + power) * log_error), scale);
        m.minimum_detectable = upwards ? bin.band.high * factor : bin.band.low / factor;
    }
    return m;
}

BinsVerdict judge_bins(const BinEffects& effects, Combination combine, double alpha, double pass_alpha) {
    const auto& bins = effects.bins;
    FF_EXPECT(!bins.empty());
    const Reach reach = reach_of(effects, pass_alpha);
    std::vector<double> p(bins.size());
    std::size_t inside = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        p[i] = p_value(effects, i);
        inside += is_inside(effects, i, pass_alpha, reach) ? 1u : 0u;
    }
    BinsVerdict result;
    std::vector<std::uint32_t> order(bins.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto named = static_cast<std::ptrdiff_t>(std::min(most_named, bins.size()));
    std::partial_sort(order.begin(), order.begin() + named, order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return p[a] != p[b] ? p[a] < p[b] : errors_beyond_band(bins[a]) > errors_beyond_band(bins[b]);
    });
    result.worst.assign(order.begin(), order.begin() + named);

    // Holm's steps need the smallest p-values in order, and end at the first that is not rejected.
    std::vector<double> small;
    std::copy_if(p.begin(), p.end(), std::back_inserter(small), [&](double value) { return value <= alpha; });
    std::sort(small.begin(), small.end());
    for (std::size_t i = 0; i < small.size() && small[i] * static_cast<double>(p.size() - i) <= alpha; ++i)
        ++result.rejected;
    result.undecided = bins.size() - inside - result.rejected;
    switch (combine) {
        case Combination::holm:
            result.p = std::min(1.0, p[order.front()] * static_cast<double>(p.size()));
            break;
        case Combination::simes:
            result.p = stats::simes(p);
            break;
        case Combination::cauchy:
            result.p = stats::cauchy_combination(p);
            break;
        case Combination::chi_squared:
            result.p = effects.together ? *effects.together : stats::chi_squared_combination(p);
            break;
    }
    result.verdict = result.p <= alpha ? Verdict::fail : inside == bins.size() ? Verdict::pass : Verdict::inconclusive;
    return result;
}

std::vector<std::uint64_t> count_scores(const std::vector<BinEffect>& bins) {
    const auto steps = static_cast<std::size_t>(2 * largest_score / score_step);
    std::vector<std::uint64_t> counts(steps);
    for (const BinEffect& bin : bins) {
        const double score = bin.value / bin.error;
        const double place = std::floor((score + largest_score) / score_step);
        ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(steps - 1)))];
    }
    return counts;
}

double rms_score(const std::vector<BinEffect>& bins) {
    double sum = 0;
    for (const BinEffect& bin : bins) sum += bin.value / bin.error * (bin.value / bin.error);
    return std::sqrt(sum / static_cast<double>(bins.size()));
}

}  // namespace ff::studies::gates
