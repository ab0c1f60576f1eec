#include "tests/contract/assertions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <numeric>

namespace ff::test {

testing::AssertionResult equally_likely(std::span<const std::uint64_t> counts, StatisticalRisk risk) {
    namespace bm = boost::math;
    const auto draws = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    const double expected = draws / static_cast<double>(counts.size());
    const auto freedom = static_cast<double>(counts.size() - 1);
    const double critical = quantile(complement(bm::chi_squared(freedom), risk.alpha));

    const bm::non_central_chi_squared alternative(freedom, draws * risk.detects * risk.detects);
    if (const double power = cdf(complement(alternative, critical)); power < risk.power) {
        return testing::AssertionFailure() << draws << " draws notice a deviation of " << risk.detects
                                           << " with probability " << power << " only. Use more";
    }
    double statistic = 0;
    for (const std::uint64_t count : counts) {
        const double deviation = static_cast<double>(count) - expected;
        statistic += deviation * deviation / expected;
    }
    if (statistic <= critical) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "chi-squared = " << statistic << " > " << critical << " with " << freedom
                                       << " degrees of freedom, alpha = " << risk.alpha;
}

testing::AssertionResult uncorrelated(std::span<const double> x, std::span<const double> y, StatisticalRisk risk) {
    const auto n = static_cast<double>(x.size());
    const boost::math::normal standard;
    const double critical = quantile(complement(standard, risk.alpha / 2)) / std::sqrt(n - 3);
    const double detectable = std::tanh(critical + quantile(standard, risk.power) / std::sqrt(n - 3));
    if (!(detectable <= risk.detects))
        return testing::AssertionFailure() << n << " pairs notice a correlation of " << detectable << ". Use more";

    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
    const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(xx > 0 && yy > 0)) return testing::AssertionFailure() << "numbers without spread show nothing";
    const double correlation = xy / std::sqrt(xx * yy);
    if (std::abs(correlation) <= std::tanh(critical)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "correlation " << correlation << ", alpha = " << risk.alpha;
}

}  // namespace ff::test
