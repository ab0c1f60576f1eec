#include "stats/error_rates/power.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::stats {
namespace {

/// Mean of f(s / sigma) over s / sigma <= limit, s the standard deviation of `freedom` + 1 normal values.
template <class Function>
double average_over_spread(double freedom, double limit, const Function& f) {
    // Integrated over d = s / sigma - 1, whose standard deviation is 1 / sqrt(2 freedom), so that nothing cancels for
    // millions of trials; ten standard deviations leave out less than 1e-13.
    const double extent = 10 / std::sqrt(2 * freedom);
    const double low = std::max(-1.0, -extent);
    const double high = std::min(limit - 1, extent);
    if (high <= low) return 0;
    const double density_at_zero = freedom * boost::math::gamma_p_derivative(freedom / 2, freedom / 2);
    const auto integrand = [&](double d) {
        const double density = density_at_zero * std::exp(freedom * (std::log1p(d) - d - d * d / 2)) / (1 + d);
        return f(1 + d) * density;
    };
    // The rule's error estimate is far above its error: 1e-8 here gives 1e-10 or better. Halving more often than this
    // only chases the rounding of probabilities near 0, by a million evaluations.
    constexpr unsigned most_halvings = 8;
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, low, high, most_halvings, 1e-8);
}

/// The x > 0 at which an increasing function reaches `target`.
template <class Function>
double reach(double target, const Function& increasing) {
    double high = 1;
    while (increasing(high) < target) high *= 2;
    const double low = high > 1 ? high / 2 : 0;
    std::uintmax_t steps = 100;
    const boost::math::tools::eps_tolerance<double> tolerance(40);
    const auto bracket = boost::math::tools::toms748_solve([&](double x) { return increasing(x) - target; }, low, high,
                                                           tolerance, steps);
    return bracket.second;
}

/// The least n >= 2 with `enough(n)`, which stays true once it is.
template <class Predicate>
std::size_t least_trials(const Predicate& enough) {
    std::size_t high = 2;
    while (!enough(high)) high *= 2;
    std::size_t low = high / 2;
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (enough(middle) ? high : low) = middle;
    }
    return std::max<std::size_t>(high, 2);
}

/// Bias in standard errors of the mean.
double in_standard_errors(double bias, double sigma, std::size_t trials) {
    return bias * std::sqrt(static_cast<double>(trials)) / sigma;
}

/// Probability that the two-sided test rejects, if the mean of its statistic lies `shift` standard errors from the null
/// hypothesis.
double rejection_probability(double shift, double freedom, double critical) {
    return average_over_spread(freedom, std::numeric_limits<double>::infinity(), [&](double s) {
        return normal_tail(critical * s - shift) + normal_tail(critical * s + shift);
    });
}

/// Probability that two one-sided tests show equivalence; margin and shift are in standard errors.
double acceptance_probability(double margin, double shift, double freedom, double critical) {
    return average_over_spread(freedom, margin / critical, [&](double s) {
        const double room = margin - critical * s;
        return 1 - normal_tail(room - shift) - normal_tail(room + shift);
    });
}

double power_for_each(double power, std::size_t pairs) {
    return 1 - (1 - power) / static_cast<double>(pairs);
}

void expect_valid_risks([[maybe_unused]] Risks risks) {
    FF_EXPECT(0 < risks.alpha && risks.alpha < risks.power && risks.power <= 1 - 1e-9);
}

}  // namespace

double minimum_detectable_bias(double sigma, std::size_t trials, Risks risks) {
    FF_EXPECT(sigma >= 0 && trials >= 2);
    expect_valid_risks(risks);
    const double freedom = static_cast<double>(trials - 1);
    const double critical = student_critical(freedom, risks.alpha / 2);
    const double shift = reach(risks.power, [&](double x) { return rejection_probability(x, freedom, critical); });
    return shift * sigma / std::sqrt(static_cast<double>(trials));
}

double equivalence_power(double margin, double bias, double sigma, std::size_t trials, double alpha) {
    FF_EXPECT(margin > 0 && sigma > 0 && trials >= 2 && alpha < 0.5);
    const double freedom = static_cast<double>(trials - 1);
    return acceptance_probability(in_standard_errors(margin, sigma, trials), in_standard_errors(bias, sigma, trials),
                                  freedom, student_critical(freedom, alpha));
}

double equivalence_margin(double sigma, std::size_t trials, Risks risks, std::size_t pairs) {
    FF_EXPECT(sigma >= 0 && trials >= 2 && pairs >= 1 && risks.alpha < 0.5);
    expect_valid_risks(risks);
    const double freedom = static_cast<double>(trials - 1);
    const double critical = student_critical(freedom, risks.alpha);
    const double margin = reach(power_for_each(risks.power, pairs),
                                [&](double x) { return acceptance_probability(x, 0, freedom, critical); });
    return margin * sigma / std::sqrt(static_cast<double>(trials));
}

std::size_t trials_for_equivalence(double margin, double sigma, Risks risks, std::size_t pairs) {
    FF_EXPECT(margin > 0 && pairs >= 1);
    expect_valid_risks(risks);
    const double power = power_for_each(risks.power, pairs);
    return least_trials(
        [&](std::size_t trials) { return equivalence_power(margin, 0, sigma, trials, risks.alpha) >= power; });
}

double detectable_deviation(std::size_t cells, std::uint64_t draws, Risks risks) {
    FF_EXPECT(cells >= 2 && draws >= 1);
    const auto freedom = static_cast<double>(cells - 1);
    const double noncentrality = boost::math::non_central_chi_squared::find_non_centrality(
        freedom, chi_squared_critical(freedom, risks.alpha), 1 - risks.power);
    return std::sqrt(noncentrality / static_cast<double>(draws));
}

double detectable_difference(const MeanEvidence& evidence, Risks risks) {
    const Interval interval = interval_of(evidence, 1 - risks.alpha);
    const double reach = std::max(evidence.difference - interval.low, interval.high - evidence.difference);
    return reach + normal_critical(1 - risks.power) * evidence.standard_error;
}

}  // namespace ff::stats
