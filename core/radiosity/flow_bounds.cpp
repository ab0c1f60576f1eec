#include "core/radiosity/flow_bounds.hpp"

#include "core/support/contract.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace ff {
namespace {

using Eigen::Index;

/// The row within its intervals that adds up to 1 and weighs `values` most.
void choose_row(const FactorBounds& factors, Index row, const std::vector<Index>& order, Eigen::MatrixXd& chosen) {
    chosen.row(row) = factors.low.row(row);
    double left = 1 - chosen.row(row).sum();
    for (const Index column : order) {
        if (left <= 0) break;
        const double more = std::min(left, factors.high(row, column) - factors.low(row, column));
        chosen(row, column) += more;
        left -= more;
    }
}

/// The largest irradiations.
Eigen::VectorXd largest(const FactorBounds& factors, const FaceLaws& laws) {
    const Index n = factors.low.rows();
    Eigen::VectorXd radiosity = laws.emitted;
    Eigen::VectorXd irradiation = Eigen::VectorXd::Constant(n, -std::numeric_limits<double>::infinity());
    Eigen::MatrixXd chosen(n, n + 1);
    std::vector<Index> order(static_cast<std::size_t>(n) + 1);
    std::iota(order.begin(), order.end(), Index{0});
    // Each choice is at least as good as the one before; there are finitely many, and a handful is enough.
    constexpr int most_choices = 1000;
    for (int i = 0; i < most_choices; ++i) {
        const auto value = [&](Index column) { return column == n ? laws.surroundings : radiosity[column]; };
        std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return value(a) > value(b); });
        for (Index row = 0; row < n; ++row) choose_row(factors, row, order, chosen);
        // H = F (e + r H) + f s
        const Eigen::MatrixXd between = chosen.leftCols(n);
        const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n) - between * laws.reflected.asDiagonal();
        const Eigen::VectorXd next =
            system.partialPivLu().solve(between * laws.emitted + chosen.col(n) * laws.surroundings);
        const double scale = std::max(next.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
        const bool grows = ((next - irradiation).array() > 1e-14 * scale).any();
        irradiation = irradiation.cwiseMax(next);
        radiosity = laws.emitted + laws.reflected.cwiseProduct(irradiation);
        if (!grows) break;
    }
    return irradiation;
}

}  // namespace

AbsorptionFound find_absorption(const FactorBounds& factors, const FaceLaws& laws) {
    const Index n = factors.low.rows();
    const auto first_cut_off = [&](const Eigen::MatrixXd& shares) {
        std::vector<bool> reaches(static_cast<std::size_t>(n));
        std::vector<Index> reached;
        for (Index i = 0; i < n; ++i) {
            reaches[static_cast<std::size_t>(i)] = laws.reflected[i] < 1 || shares(i, n) > 0;
            if (reaches[static_cast<std::size_t>(i)]) reached.push_back(i);
        }
        while (!reached.empty()) {
            const Index to = reached.back();
            reached.pop_back();
            for (Index from = 0; from < n; ++from) {
                if (reaches[static_cast<std::size_t>(from)] || shares(from, to) <= 0) continue;
                reaches[static_cast<std::size_t>(from)] = true;
                reached.push_back(from);
            }
        }
        return std::find(reaches.begin(), reaches.end(), false) - reaches.begin();
    };
    if (const Index face = first_cut_off(factors.high); face < n) return {Absorption::not_reached, face};
    if (const Index face = first_cut_off(factors.low); face < n) return {Absorption::unresolved, face};
    return {};
}

bool can_add_up(const FactorBounds& factors, Index row) {
    return factors.low.row(row).sum() <= 1 && factors.high.row(row).sum() >= 1;
}

IrradiationBounds bound_irradiation(const FactorBounds& factors, const FaceLaws& laws) {
    FF_EXPECT(factors.low.cols() == factors.low.rows() + 1);
    FF_EXPECT(find_absorption(factors, laws).absorption == Absorption::reached);
    // The least are the largest of everything negated.
    const FaceLaws negated{-laws.emitted, laws.reflected, -laws.surroundings};
    IrradiationBounds bounds{-largest(factors, negated), largest(factors, laws)};
    // Rounding of the solutions, by far.
    const double margin = 1e-11 * std::max(bounds.low.cwiseAbs().maxCoeff(), bounds.high.cwiseAbs().maxCoeff());
    bounds.low.array() -= margin;
    bounds.high.array() += margin;
    return bounds;
}

}  // namespace ff
