#include "stats/goodness_of_fit/discrepancy.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// (sum over i of prod over d of f(x_id), sum over i and k of prod over d of g(x_id, x_kd))
template <class Single, class Pair>
std::pair<double, double> sums(const Coordinates& points, Single f, Pair g) {
    FF_EXPECT(!points.empty() && !points.front().empty());
    const std::size_t n = points.front().size();
    double single = 0;
    double pairs = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double own = 1;
        for (const auto& row : points) own *= f(row[i]);
        single += own;
        for (std::size_t k = 0; k < n; ++k) {
            double both = 1;
            for (const auto& row : points) both *= g(row[i], row[k]);
            pairs += both;
        }
    }
    return {single, pairs};
}

}  // namespace

double l2_star_discrepancy(const Coordinates& points) {
    const auto n = static_cast<double>(points.front().size());
    const auto d = static_cast<double>(points.size());
    const auto [single, pairs] = sums(
        points, [](double x) { return 1 - x * x; }, [](double x, double y) { return 1 - std::max(x, y); });
    return std::sqrt(std::max(0.0, std::pow(3.0, -d) - std::pow(2.0, 1 - d) * single / n + pairs / (n * n)));
}

double centred_discrepancy(const Coordinates& points) {
    const auto n = static_cast<double>(points.front().size());
    const auto d = static_cast<double>(points.size());
    const auto [single, pairs] = sums(
        points,
        [](double x) {
            const double c = std::abs(x - 0.5);
            return 1 + c / 2 - c * c / 2;
        },
        [](double x, double y) { return 1 + std::abs(x - 0.5) / 2 + std::abs(y - 0.5) / 2 - std::abs(x - y) / 2; });
    return std::sqrt(std::max(0.0, std::pow(13.0 / 12, d) - 2 * single / n + pairs / (n * n)));
}

double largest_gap(std::span<const double> coordinates) {
    FF_EXPECT(!coordinates.empty());
    const std::vector<double> ascending = sorted(coordinates);
    double gap = ascending.front() + 1 - ascending.back();
    for (std::size_t i = 1; i < ascending.size(); ++i) gap = std::max(gap, ascending[i] - ascending[i - 1]);
    return gap;
}

}  // namespace ff::stats
