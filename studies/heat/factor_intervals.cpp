#include "studies/heat/factor_intervals.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ff::studies::heat {
namespace {

using Eigen::Index;

/// Intervals of the factors, and of what they leave. Every row of a closed scene whose surfaces all belong to faces
/// adds up to 1; otherwise what is left is seen through openings, or lies on surfaces of no face.
/// @param widths  factor on the widths of a face's sampled factors, at least 1
FactorBounds factor_bounds(const Scene& scene, const form_factors::Matrix& matrix, const std::vector<double>& widths) {
    const auto n = static_cast<Index>(matrix.faces());
    std::vector<Eigen::Triplet<double>> low;
    std::vector<Eigen::Triplet<double>> high;
    const auto set = [&](Index i, Index j, double least, double most) {
        low.emplace_back(i, j, std::clamp(least, 0.0, 1.0));
        high.emplace_back(i, j, std::clamp(most, 0.0, 1.0));
    };
    for (const form_factors::FaceExchange& exchange : matrix.exchanges) {
        const double width = exchange.is_sampled() ? std::max(widths[exchange.from], widths[exchange.to]) : 1;
        const double least = exchange.low - (width - 1) * (exchange.value - exchange.low);
        const double most = exchange.high + (width - 1) * (exchange.high - exchange.value);
        const auto set_from = [&](Index i, Index j, double area) { set(i, j, least / area, most / area); };
        set_from(exchange.from, exchange.to, matrix.areas[exchange.from]);
        if (exchange.from != exchange.to) set_from(exchange.to, exchange.from, matrix.areas[exchange.to]);
    }
    for (Index i = 0; i < n; ++i) {
        if (form_factors::rows_add_up(scene)) break;
        const form_factors::RowSum& row = matrix.rows[static_cast<std::size_t>(i)];
        set(i, n, 1 - row.high, 1 - row.low);
    }
    FactorBounds bounds{FactorBounds::Sparse(n, n + 1), FactorBounds::Sparse(n, n + 1)};
    bounds.low.setFromTriplets(low.begin(), low.end());
    bounds.high.setFromTriplets(high.begin(), high.end());
    return bounds;
}

/// How much wider the intervals of all sampled factors are if one of them misses with a probability of 1e-6. The
/// intervals are Student's.
double widest(const form_factors::Matrix& matrix) {
    constexpr double chance = 1e-6;
    constexpr auto freedom = static_cast<double>(form_factors::randomisations - 1);
    const auto sampled = std::ranges::count_if(matrix.exchanges, &form_factors::FaceExchange::is_sampled);
    const double tail = (1 - matrix.entry_level) / 2;
    const double smaller = chance / 2 / static_cast<double>(std::max<std::ptrdiff_t>(1, sampled));
    return tail <= smaller ? 1 : stats::student_critical(freedom, smaller) / stats::student_critical(freedom, tail);
}

}  // namespace

PossibleFactors possible_factors(const Scene& scene, const form_factors::Matrix& matrix) {
    std::vector<double> widths(matrix.faces(), 1.0);
    PossibleFactors factors{factor_bounds(scene, matrix, widths), {}};
    for (std::size_t i = 0; i < matrix.faces(); ++i) {
        if (can_add_up(factors.bounds, static_cast<Index>(i))) continue;
        widths[i] = widest(matrix);
        factors.widened.push_back(i);
    }
    if (!factors.widened.empty()) factors.bounds = factor_bounds(scene, matrix, widths);
    return factors;
}

/// Whether a face may see out of the scene, by more than the rounding of a row of exact factors.
bool sees_out(const FactorBounds& factors, Index face) {
    constexpr double rounding = 1e-12;
    return factors.high.coeff(face, factors.high.rows()) > rounding;
}

bool sees_out(const FactorBounds& factors) {
    for (Index i = 0; i < factors.high.rows(); ++i) {
        if (sees_out(factors, i)) return true;
    }
    return false;
}

}  // namespace ff::studies::heat
