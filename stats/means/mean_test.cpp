#include "stats/means/mean_test.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::stats {
namespace {

/// The difference of two independent parts: their variances and third moments add.
MeanEvidence less(const MeanEvidence& second, const MeanEvidence& first) {
    MeanEvidence both = second;
    both.difference = second.difference - first.difference;
    both.standard_error = std::hypot(first.standard_error, second.standard_error);
    // Computed as shares of the whole: squares of variances of 1e-160 would be 0.
    const double a = std::pow(first.standard_error / both.standard_error, 2);
    const double b = std::pow(second.standard_error / both.standard_error, 2);
    both.freedom = 1 / (a * a / first.freedom + b * b / second.freedom);
    const double of_first = std::pow(a, 1.5);
    const double of_second = std::pow(b, 1.5);
    const gate::MeanSkewness& x = first.skewness;
    const gate::MeanSkewness& y = second.skewness;
    const auto weighted = [](double weight, double limit) { return weight > 0 ? weight * limit : 0; };
    both.skewness = {.value = of_second * y.value - of_first * x.value,
                     .error = std::hypot(of_first * x.error, of_second * y.error),
                     .insignificant = std::min(x.insignificant, y.insignificant) < 0
                                          ? -std::numeric_limits<double>::infinity()
                                          : std::hypot(of_first * x.insignificant, of_second * y.insignificant),
                     .most = weighted(of_second, y.most) + weighted(of_first, x.most)};
    both.method = "skewed_welch_t";
    return both;
}

/// A mean, with or without spread, computed about the first value, so that values far from 0 keep their digits.
MeanEvidence mean_of(std::span<const double> values, double reference) {
    if (const auto evidence = mean_evidence(values, reference)) return *evidence;
    return {.difference = values.front() - reference, .freedom = 1, .skewness = {}, .method = {}, .n = values.size()};
}

/// How far a mean may be off on one side, except with probability `tail`.
double reach_of(const MeanEvidence& mean, int side, double tail) {
    return mean.reach_of_met(side, tail) + mean.unmet.reach(mean.unmet.tail_of_unmet(tail)) + mean.rounding +
           (side > 0 ? mean.unseen : 0);
}

double reach_of(const Measured::Part& part, int side, double tail) {
    const int of_mean = part.weight < 0 ? -side : side;
    const MeanEvidence& mean = part.mean;
    double reach = mean.reach_of_met(of_mean, tail);
    // Values that no evaluation has met, or that few trials do not show, can only increase a mean square.
    if (of_mean > 0) reach += mean.unmet.reach(mean.unmet.tail_of_unmet(tail)) + mean.unseen;
    const double weight = std::abs(part.weight);
    return weight * (part.logarithm ? gate::reach_of_logarithm(of_mean, reach / mean.difference) : reach);
}

/// Both reaches, added as the sides of a right triangle.
double reach_of_difference(const Measured& first, const Measured& second, int side, double tail, double correlation) {
    const double a = second.reach(side, tail);
    const double b = first.reach(-side, tail);
    if (std::isinf(a) || std::isinf(b)) return std::numeric_limits<double>::infinity();
    return std::sqrt(std::max(0.0, a * a + b * b - 2 * correlation * a * b));
}

std::size_t fewest(const Measured& first, const Measured& second) {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const Measured* each : {&first, &second}) {
        for (const Measured::Part& part : each->parts) fewest = std::min(fewest, part.mean.n);
    }
    return fewest;
}

}  // namespace

double MeanEvidence::reach_of_met(int side, double tail) const {
    const double met = unmet.tail_of_met(tail);
    return standard_error * gate::skewed_reach(skewness, side, student_critical(freedom, met), normal_critical(met));
}

double Unmet::reach(double tail) const {
    return largest == 0 ? 0 : -largest * std::expm1(std::log(tail) / evaluations);
}

std::optional<MeanEvidence> mean_evidence(std::span<const double> values, double reference, const KnownLimits& limits,
                                          const std::optional<Autocorrelation>& correlation) {
    if (values.size() < 3) return std::nullopt;
    // The spread is computed about one of the values, so that a distant reference costs no digits.
    const Moments moments = moments_of(values, values.front());
    const double independent = *moments.standard_error();
    const auto n = static_cast<double>(values.size());
    const double time = correlation ? correlation->time : 1;
    const double effective = n / time;
    const double freedom = (correlation ? std::min(correlation->freedom, effective) : n) - 1;
    if (independent == 0 || effective < 2 || freedom < 1) return std::nullopt;
    MeanEvidence mean{.difference = *moments_of(values, reference).bias(),
                      .standard_error = independent * std::sqrt(time),
                      .freedom = freedom,
                      .skewness = gate::skewness_of_mean(values, effective),
                      .unmet = limits.unmet,
                      .rounding = limits.rounding,
                      .method = "skewed_t",
                      .n = values.size()};
    mean.skewness.most = limits.largest_part / *moments.standard_deviation() / std::sqrt(effective);
    return mean;
}

MeanEvidence mean_evidence_after(const Pilot& pilot, std::span<const double> values, double reference,
                                 const KnownLimits& limits) {
    const auto n = static_cast<double>(values.size());
    return {.difference = *moments_of(values, reference).bias(),
            .standard_error = pilot.standard_deviation / std::sqrt(n),
            .freedom = pilot.freedom(),
            .skewness = pilot.skewness_at(values.size()),
            .unmet = limits.unmet,
            .rounding = limits.rounding,
            .method = "stein_two_stage",
            .n = values.size()};
}

std::optional<MeanEvidence> difference_of_means(std::span<const double> first, std::span<const double> second) {
    if (first.size() < 3 || second.size() < 3) return std::nullopt;
    const MeanEvidence a = mean_of(first, first.front());
    const MeanEvidence b = mean_of(second, first.front());
    return a.standard_error + b.standard_error == 0 ? std::nullopt : std::optional(less(b, a));
}

MeanEvidence with_uncertain_reference(const MeanEvidence& mean, double standard_error, double freedom,
                                      const gate::MeanSkewness& skewness) {
    if (standard_error == 0) return mean;
    return less(mean, {.standard_error = standard_error, .freedom = freedom, .skewness = skewness, .method = {}});
}

Interval interval_of(const MeanEvidence& mean, double level) {
    const double tail = (1 - level) / 2;
    return {.low = mean.difference - reach_of(mean, -1, tail),
            .high = mean.difference + reach_of(mean, 1, tail),
            .level = level,
            .method = mean.method,
            .n = mean.n};
}

std::optional<Interval> mean_interval(std::span<const double> values, double reference, double level,
                                      const KnownLimits& limits) {
    const auto mean = mean_evidence(values, reference, limits);
    if (!mean) return std::nullopt;
    const Interval interval = interval_of(*mean, level);
    return interval.is_finite() ? std::optional(interval) : std::nullopt;
}

MeanTest test_mean(const MeanEvidence& mean) {
    FF_EXPECT(mean.standard_error > 0);
    MeanTest test;
    test.student_p = student_two_sided_p(mean.t(), mean.freedom);
    if (mean.skewness.most == 0 && mean.unmet.largest == 0 && mean.rounding == 0)
        return {test.student_p, test.student_p};
    const int side = mean.difference > 0 ? -1 : 1;
    // The smallest tail is that of Student's t.
    test.p = two_sided_p([&](double tail) { return std::abs(mean.difference) > reach_of(mean, side, tail); },
                         test.student_p);
    return test;
}

double two_sided_p(const std::function<bool(double)>& leaves_out, double least) {
    double excluding = 0;
    // z of a p-value of 1e-300 is 37.
    double including = std::min(37.0, least > 0 ? normal_critical(least / 2) : 37.0);
    if (!(including > 0)) return 1;
    for (int i = 0; i < 40; ++i) {
        const double z = (excluding + including) / 2;
        (z > 0 && leaves_out(normal_tail(z)) ? excluding : including) = z;
    }
    return normal_two_sided_p(including);
}

UnseenValue unseen_value(double mean, double reference, std::size_t n, double tail) {
    const double share = -std::expm1(std::log(tail) / static_cast<double>(n));
    return {.value = mean + (reference - mean) / share, .one_in = 1 / share};
}

double Measured::reach(int side, double tail) const {
    double squares = 0;
    for (const Part& part : parts) {
        const double reach = reach_of(part, side, tail);
        squares += reach * reach;
    }
    return std::sqrt(squares);
}

double Measured::standard_error() const {
    double error = 0;
    for (const Part& part : parts) {
        const MeanEvidence& mean = part.mean;
        error = std::hypot(error, part.weight * mean.standard_error / (part.logarithm ? mean.difference : 1));
    }
    return error;
}

Measured logarithm_of(const MeanEvidence& mean, double scale) {
    FF_EXPECT(mean.difference > 0 && scale > 0);
    return {std::log(scale * mean.difference), {{.mean = mean, .logarithm = true}}};
}

Measured with_error(double value, double standard_error, std::size_t trials) {
    FF_EXPECT(standard_error >= 0 && trials > 1);
    return {value,
            {{.mean = {.standard_error = standard_error,
                       .freedom = static_cast<double>(trials - 1),
                       .skewness = {.most = no_part},
                       .method = {},
                       .n = trials}}}};
}

std::optional<Interval> difference_interval(const Measured& first, const Measured& second, double level,
                                            double correlation) {
    if (first.is_exact() && second.is_exact()) return std::nullopt;
    const double difference = second.value - first.value;
    const double tail = (1 - level) / 2;
    return Interval{.low = difference - reach_of_difference(first, second, -1, tail, correlation),
                    .high = difference + reach_of_difference(first, second, 1, tail, correlation),
                    .level = level,
                    .method = "square_and_add",
                    .n = fewest(first, second)};
}

double p_of_equal(const Measured& first, const Measured& second) {
    const double difference = second.value - first.value;
    if (first.is_exact() && second.is_exact()) return difference == 0 ? 1 : 0;
    return two_sided_p([&](double tail) {
        return std::abs(difference) > reach_of_difference(first, second, difference > 0 ? -1 : 1, tail, 0);
    });
}

}  // namespace ff::stats
