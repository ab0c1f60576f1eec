#include "studies/heat/factor_intervals.hpp"

#include "studies/form_factors/closure.hpp"

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
        const auto [least, most] = form_factors::widened(exchange, width);
        const auto set_from = [&, low_end = least, high_end = most](Index i, Index j, double area) {
            set(i, j, low_end / area, high_end / area);
        };
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

}  // namespace

PossibleFactors possible_factors(const Scene& scene, const form_factors::Matrix& matrix) {
    std::vector<double> widths(matrix.faces(), 1.0);
    PossibleFactors factors{factor_bounds(scene, matrix, widths), {}};
    for (std::size_t i = 0; i < matrix.faces(); ++i) {
        if (can_add_up(factors.bounds, static_cast<Index>(i))) continue;
        widths[i] = form_factors::widest_by_chance(matrix);
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
