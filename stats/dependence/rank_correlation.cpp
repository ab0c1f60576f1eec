#include "stats/dependence/rank_correlation.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <cmath>

namespace ff::stats {
namespace {

int sign_of(double x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

}  // namespace

std::optional<RankCorrelation> rank_correlation(std::span<const double> first, std::span<const double> second,
                                                double level) {
    FF_EXPECT(first.size() == second.size());
    const std::size_t n = first.size();
    if (n < fewest_ranked) return std::nullopt;
    double agreement = 0;
    double of_first = 0;
    double of_second = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const int a = sign_of(first[i] - first[j]);
            const int b = sign_of(second[i] - second[j]);
            agreement += a * b;
            of_first += a * a;
            of_second += b * b;
        }
    }
    if (of_first == 0 || of_second == 0) return std::nullopt;
    RankCorrelation found;
    found.tau = agreement / std::sqrt(of_first * of_second);
    const double z = normal_critical((1 - level) / 2);
    const double c = 2 * z * z / static_cast<double>(n);
    const double reach = std::sqrt(c * (1 + c - found.tau * found.tau));
    found.interval = {.low = (found.tau - reach) / (1 + c),
                      .high = (found.tau + reach) / (1 + c),
                      .level = level,
                      .method = "kendall_bound",
                      .n = n};
    return found;
}

}  // namespace ff::stats
