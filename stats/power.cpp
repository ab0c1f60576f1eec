#include "stats/power.hpp"

#include "core/contract.hpp"
#include "stats/distributions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ff::stats {
namespace {

/// Mean of f(s / sigma) over s / sigma <= limit, s the standard deviation of `freedom` + 1 normal values.
template <class Function>
double average_over_spread(double freedom, double limit, const Function& f) {
    constexpr double negligible = 1e-16;
    const boost::math::chi_squared law(freedom);
    const double low = std::sqrt(quantile(law, negligible) / freedom);
    const double high = std::min(limit, std::sqrt(quantile(complement(law, negligible)) / freedom));
    if (high <= low) return 0;
    const auto integrand = [&](double s) { return f(s) * pdf(law, freedom * s * s) * 2 * freedom * s; };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, low, high, 15, 1e-11);
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
double standardise(double bias, double sigma, std::size_t trials) {
    return bias * std::sqrt(static_cast<double>(trials)) / sigma;
}

double rejection_probability(double shift, double freedom, double alpha) {
    const double critical = student_critical(freedom, alpha / 2);
    return average_over_spread(freedom, std::numeric_limits<double>::infinity(), [&](double s) {
        return normal_tail(critical * s - shift) + normal_tail(critical * s + shift);
    });
}

double acceptance_probability(double margin, double shift, double freedom, double alpha) {
    const double critical = student_critical(freedom, alpha);
    return average_over_spread(freedom, margin / critical, [&](double s) {
        const double room = margin - critical * s;
        return 1 - normal_tail(room - shift) - normal_tail(room + shift);
    });
}

double power_for_each(double power, std::size_t pairs) {
    return 1 - (1 - power) / static_cast<double>(pairs);
}

void expect_valid([[maybe_unused]] Risks risks) {
    FF_EXPECT(0 < risks.alpha && risks.alpha < risks.power && risks.power < 1);
}

}  // namespace

double bias_test_power(double bias, double sigma, std::size_t trials, double alpha) {
    FF_EXPECT(sigma > 0 && trials >= 2);
    return rejection_probability(standardise(bias, sigma, trials), static_cast<double>(trials - 1), alpha);
}

double minimum_detectable_bias(double sigma, std::size_t trials, Risks risks) {
    FF_EXPECT(sigma >= 0 && trials >= 2);
    expect_valid(risks);
    const double freedom = static_cast<double>(trials - 1);
    const double shift = reach(risks.power, [&](double x) { return rejection_probability(x, freedom, risks.alpha); });
    return shift * sigma / std::sqrt(static_cast<double>(trials));
}

std::size_t trials_for_bias(double bias, double sigma, Risks risks) {
    FF_EXPECT(bias > 0);
    expect_valid(risks);
    return least_trials(
        [&](std::size_t trials) { return bias_test_power(bias, sigma, trials, risks.alpha) >= risks.power; });
}

double equivalence_power(double margin, double bias, double sigma, std::size_t trials, double alpha) {
    FF_EXPECT(margin > 0 && sigma > 0 && trials >= 2 && alpha < 0.5);
    return acceptance_probability(standardise(margin, sigma, trials), standardise(bias, sigma, trials),
                                  static_cast<double>(trials - 1), alpha);
}

double equivalence_margin(double sigma, std::size_t trials, Risks risks, std::size_t pairs) {
    FF_EXPECT(sigma >= 0 && trials >= 2 && pairs >= 1 && risks.alpha < 0.5);
    expect_valid(risks);
    const double freedom = static_cast<double>(trials - 1);
    const double margin = reach(power_for_each(risks.power, pairs),
                                [&](double x) { return acceptance_probability(x, 0, freedom, risks.alpha); });
    return margin * sigma / std::sqrt(static_cast<double>(trials));
}

std::size_t trials_for_equivalence(double margin, double sigma, Risks risks, std::size_t pairs) {
    FF_EXPECT(margin > 0 && pairs >= 1);
    expect_valid(risks);
    const double power = power_for_each(risks.power, pairs);
    return least_trials(
        [&](std::size_t trials) { return equivalence_power(margin, 0, sigma, trials, risks.alpha) >= power; });
}

double minimum_detectable_shift(double probability, std::size_t trials, Risks risks) {
    FF_EXPECT(0 < probability && probability < 1 && trials >= 1);
    expect_valid(risks);
    const double sd = std::sqrt(probability * (1 - probability) / static_cast<double>(trials));
    return (normal_critical(risks.alpha / 2) + normal_critical(1 - risks.power)) * sd;
}

}  // namespace ff::stats
