#pragma once

// Gates on means and spreads of Monte Carlo trials, for unit tests: headers only, C++17, nothing but the standard
// library. Installed as <ffstudy/gate.hpp>; gate_macros.hpp makes them assertions. docs/gates-in-practice.md shows how.
//
// The rule is that of `ffstudy check` (docs/gates.md), which calls gate_verdict.hpp and skewed_reach.hpp here
// too. Since this header stands alone, its quantiles are good to ten digits only, a mean beside an uncertain reference
// keeps its own skewness (which is more cautious), trials that would decide are counted by the normal law, and repeats,
// serial correlation and heavy tails are not looked for. tests/data/gate_cases.csv has cases that all judge alike.

#include "stats/gates/gate_quantiles.hpp"
#include "stats/gates/gate_verdict.hpp"
#include "stats/gates/skewed_reach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace ff::gate {

/// The tolerated band, and both risks.
struct Options {
    double band = 0;      ///< for means, |mean - reference| <= band; for spreads, a ratio from 1/(1+band) to 1+band
    double alpha = 1e-4;  ///< probability of failing although the effect lies in the band
    double power = 0.9;  ///< probability of passing where there is no effect, with the trials that the message asks for
    double pass_alpha = 0.05;     ///< probability of passing although the effect lies at an end of the band or beyond
    double reference_error = 0;   ///< standard error of the reference
    std::size_t comparisons = 1;  ///< gates that share alpha
};

/// A mean with its standard error, as codes report them, where single trials are not available.
struct Estimate {
    double mean = 0;
    double standard_error = 0;
    double n = std::numeric_limits<double>::infinity();  ///< values behind it
};

/// The result of a gate.
struct Result {
    Verdict verdict = Verdict::inconclusive;
    double effect = 0;  ///< mean - reference, or spread / reference
    double low = 0;     ///< lower end of the interval that has to lie in the band
    double high = 0;
    double band_low = 0;
    double band_high = 0;
    double n = 0;                 ///< trials
    double trials_to_decide = 0;  ///< trials needed to pass with the power where there is no effect; 0 where unknown
    Options options;
    const char* note = "";   ///< what limits the verdict
    const char* fault = "";  ///< why there is no verdict

    explicit operator bool() const { return verdict == Verdict::pass; }
};

/// Effect, interval, band, both risks, and how many trials would decide.
inline std::string message(const Result& result) {
    std::ostringstream out;
    out.precision(4);
    out << (result.verdict == Verdict::pass   ? "pass: "
            : result.verdict == Verdict::fail ? "FAIL: "
                                              : "INCONCLUSIVE (no pass): ");
    if (*result.fault != 0) {
        out << result.fault;
        return out.str();
    }
    out << "effect " << result.effect << ", interval " << result.low << " to " << result.high << ", band "
        << result.band_low << " to " << result.band_high << "; alpha " << result.options.alpha;
    if (result.options.comparisons > 1) out << " over " << result.options.comparisons << " gates";
    out << ", power " << result.options.power << "; " << result.n << " trials";
    if (result.verdict == Verdict::inconclusive && result.trials_to_decide > result.n)
        out << ", about " << static_cast<long long>(std::min(1e18, std::ceil(result.trials_to_decide)))
            << " pass with that power if there is no effect";
    if (*result.note != 0) out << ". " << result.note;
    return out.str();
}

namespace detail {

struct Range {
    double low;
    double high;
};

/// @param limit  of tail probability `tail` on one side (-1 or 1) of the effect
template <class Limit>
Result judged(double effect, double n, Range band, const Options& options, const Limit& limit) {
    Result result;
    result.effect = effect;
    result.n = n;
    result.band_low = band.low;
    result.band_high = band.high;
    result.options = options;
    const auto between = [&](double tail) { return Range{limit(-1, tail), limit(1, tail)}; };
    const Range passing = between(options.pass_alpha);
    const Range failing = between(options.alpha / static_cast<double>(options.comparisons) / 2);
    result.low = passing.low;
    result.high = passing.high;
    result.verdict = judge(passing, failing, band);
    if (!std::isfinite(passing.high - passing.low + failing.high - failing.low))
        result.note = "Too skewed, or too few trials, for an interval at one of these levels.";
    return result;
}

inline Result undecided(double n, const char* why) {
    Result result;
    result.n = n;
    result.fault = why;
    return result;
}

/// The fault of these options; empty where they are valid.
inline const char* fault_of(const Options& o) {
    if (!(o.band > 0)) return "band (no number of trials shows an effect of exactly nothing; give a positive one)";
    if (!(o.alpha > 0 && o.alpha < 0.5)) return "alpha (give one above 0 and below 0.5)";
    if (!(o.pass_alpha > 0 && o.pass_alpha < 0.5)) return "pass_alpha (give one above 0 and below 0.5)";
    if (!(o.power >= 0.5 && o.power < 1)) return "power (give one from 0.5 to below 1)";
    if (!(o.reference_error >= 0)) return "reference_error (a standard error is not negative)";
    return o.comparisons < 1 ? "comparisons (at least 1)" : "";
}

/// The number of trials by the usual formula, corrected for Student's t.
inline double trials_for(double sigma, const Options& options) {
    const double z = normal_critical(options.pass_alpha);
    const double ratio = (z + normal_critical((1 - options.power) / 2)) * sigma;
    const double room = options.band * options.band - std::pow((ratio / sigma) * options.reference_error, 2);
    return room > 0 ? ratio * ratio / room + z * z / 2 : 0;
}

inline Result judged_mean(const Estimate& estimate, const MeanSkewness& skewness, double reference,
                          const Options& options) {
    const double error = std::hypot(estimate.standard_error, options.reference_error);
    // Welch; the reference has infinite freedom.
    const double freedom = (estimate.n - 1) * std::pow(error / estimate.standard_error, 4);
    const double effect = estimate.mean - reference;
    const auto limit = [&](int side, double tail) {
        const double t = student_critical(freedom, tail);
        return effect + side * error * skewed_reach(skewness, side, t, normal_critical(tail));
    };
    Result result = judged(effect, estimate.n, {-options.band, options.band}, options, limit);
    if (std::isfinite(estimate.n))
        result.trials_to_decide = trials_for(estimate.standard_error * std::sqrt(estimate.n), options);
    return result;
}

}  // namespace detail

/// A gate on the mean of trials, each a whole run with random numbers of its own; at least 10.
template <class Values>
Result mean(const Values& values, double reference, const Options& options) {
    double n = 0;
    double centre = 0;
    double squares = 0;
    for (const double value : values) {
        const double delta = value - centre;
        centre += delta / ++n;
        squares += delta * (value - centre);
    }
    if (const char* fault = detail::fault_of(options); *fault != 0) return detail::undecided(n, fault);
    if (!std::isfinite(squares) || !std::isfinite(reference)) return detail::undecided(n, "a value is not finite");
    if (n < 10) return detail::undecided(n, "fewer than 10 trials; 50 to 200 are usual");
    if (squares == 0) return detail::undecided(n, "every trial gave the same value: was each seeded alike?");
    const Estimate estimate{centre, std::sqrt(squares / (n - 1) / n), n};
    return detail::judged_mean(estimate, skewness_of_mean(values, n), reference, options);
}

/// A gate on a mean whose stated standard error is trusted.
inline Result mean(const Estimate& estimate, double reference, const Options& options) {
    if (const char* fault = detail::fault_of(options); *fault != 0) return detail::undecided(estimate.n, fault);
    if (!(estimate.standard_error > 0) || !std::isfinite(estimate.mean) || !(estimate.n >= 2))
        return detail::undecided(estimate.n, "a standard error has to be positive, of at least 2 values");
    MeanSkewness none;
    none.most = 0;  // known not to be skewed
    Result result = detail::judged_mean(estimate, none, reference, options);
    result.note = "The standard error is believed as it is stated.";
    return result;
}

/// A gate on the standard deviation of a trial relative to a reference, by chi-squared with degrees of freedom reduced
/// for kurtosis [box1953], and at least as far as the mean square behind it reaches; at least 10 trials.
template <class Values>
Result spread(const Values& values, double reference, const Options& options) {
    double n = 0;
    double centre = 0;
    for (const double value : values) centre += (value - centre) / ++n;
    double squares = 0;
    double fourth = 0;
    std::vector<double> deviations;
    for (const double value : values) {
        const double square = (value - centre) * (value - centre);
        squares += square;
        fourth += square * square;
        deviations.push_back(square);
    }
    if (const char* fault = detail::fault_of(options); *fault != 0) return detail::undecided(n, fault);
    if (!std::isfinite(fourth)) return detail::undecided(n, "a value is not finite, or too large");
    if (!(reference > 0)) return detail::undecided(n, "a ratio to the reference is taken; give a positive one");
    if (n < 10) return detail::undecided(n, "fewer than 10 trials; 50 to 200 are usual");
    if (squares == 0) return detail::undecided(n, "every trial gave the same value: was each seeded alike?");
    const double kurtosis = n * fourth / (squares * squares) - 3;
    const double freedom = (n - 1) / (1 + (kurtosis > 0 ? kurtosis : 0) / 2);
    const double effect = std::sqrt(squares / (n - 1)) / reference;
    for (double& square : deviations) square /= squares / n;  // so that no power of it overflows
    // The mean of the squares has this skewness, this standard error relative to itself, and this root.
    const MeanSkewness skewness = skewness_of_mean(deviations, n);
    const double error = std::sqrt(std::max(0.0, n * fourth / (squares * squares) - 1) / (n - 1));
    const double root = std::sqrt(squares / n) / reference;
    const auto limit = [&](int side, double tail) {
        const double by_kurtosis =
            effect * std::sqrt(freedom / chi_squared_critical(freedom, side < 0 ? tail : 1 - tail));
        if (error == 0) return by_kurtosis;
        const double t = student_critical(n - 1, tail);
        const double share = error * skewed_reach(skewness, side, t, normal_critical(tail));
        const double by_skewness = root * std::exp(side * reach_of_logarithm(side, share) / 2);
        return side < 0 ? std::min(by_kurtosis, by_skewness) : std::max(by_kurtosis, by_skewness);
    };
    // Squares of values with long tails are more skewed than trials show, which half the risk of a pass makes good.
    Options careful = options;
    const double kurtosis_error = std::sqrt(24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5)));
    if (kurtosis + 6 / (n + 1) > 2 * kurtosis_error) careful.pass_alpha /= 2;
    return detail::judged(effect, n, {1 / (1 + options.band), 1 + options.band}, careful, limit);
}

}  // namespace ff::gate
