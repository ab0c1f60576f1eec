#include "stats/change_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ff::stats {
namespace {

/// The largest |difference| * sqrt(k (n - k) / n) of values with mean 0, and where.
struct Largest {
    double size = 0;
    std::size_t first = 0;
};

Largest largest_difference(std::span<const double> centred) {
    const auto n = static_cast<double>(centred.size());
    Largest largest;
    double sum = 0;
    for (std::size_t k = 1; k + fewest_on_a_side <= centred.size(); ++k) {
        sum += centred[k - 1];
        if (k < fewest_on_a_side) continue;
        const auto before = static_cast<double>(k);
        const double size = std::abs(sum) * std::sqrt(n / (before * (n - before)));
        if (size > largest.size) largest = {size, k};
    }
    return largest;
}

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double least_change_p(std::size_t n) {
    const auto half = static_cast<double>(n / 2);
    const auto all = static_cast<double>(n);
    return 2 * std::exp(std::lgamma(half + 1) + std::lgamma(all - half + 1) - std::lgamma(all + 1));
}

std::optional<ChangePoint> find_change(std::span<const double> values, const ResamplingPlan& plan) {
    if (values.size() < 2 * fewest_on_a_side) return std::nullopt;
    const double mean = mean_of(values);
    std::vector<double> centred(values.begin(), values.end());
    for (double& value : centred) value -= mean;
    const Largest found = largest_difference(centred);
    if (found.size == 0) return std::nullopt;
    constexpr double rounding = 1 - 1e-12;  // the same set of values in another order is no smaller
    std::uint64_t as_large = 1;
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::permutation, replicate);
        shuffle(centred, draws);
        if (largest_difference(centred).size >= found.size * rounding) ++as_large;
    }
    return ChangePoint{.first = found.first,
                       .before = mean_of(values.first(found.first)),
                       .after = mean_of(values.subspan(found.first)),
                       .p = static_cast<double>(as_large) / (static_cast<double>(plan.replicates) + 1)};
}

}  // namespace ff::stats
