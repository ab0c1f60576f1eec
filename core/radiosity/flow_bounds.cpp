#include "core/radiosity/flow_bounds.hpp"

#include "core/radiosity/linear_map.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = FactorBounds::Sparse;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The matrix within the intervals whose rows add up to 1 and weigh `values` (of all columns) most.
void choose(const FactorBounds& factors, const VectorXd& values, Sparse& chosen) {
    const auto* const columns = factors.low.innerIndexPtr();
    const double* const low = factors.low.valuePtr();
    const double* const high = factors.high.valuePtr();
    std::vector<Index> order;
    for (Index row = 0; row < factors.low.rows(); ++row) {
        const Index begin = factors.low.outerIndexPtr()[row];
        const Index end = factors.low.outerIndexPtr()[row + 1];
        double left = 1;
        order.clear();
        for (Index k = begin; k < end; ++k) {
            chosen.valuePtr()[k] = low[k];
            left -= low[k];
            if (high[k] > low[k]) order.push_back(k);
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](Index a, Index b) { return values[columns[a]] > values[columns[b]]; });
        for (const Index k : order) {
            if (left <= 0) break;
            const double more = std::min(left, high[k] - low[k]);
            chosen.valuePtr()[k] += more;
            left -= more;
        }
    }
}

/// Solves x = constant + F reflected x + known for a matrix F between faces.
VectorXd fixed_point(const Sparse& chosen, const VectorXd& reflected, const VectorXd& known, const VectorXd& guess) {
    VectorXd sent(chosen.cols());
    const auto less_what_returns = [&](const VectorXd& x) -> VectorXd {
        sent << reflected.cwiseProduct(x), 0;
        return x - chosen * sent;
    };
    constexpr Index most_iterations = 500;  // what these leave is bounded
    return solve(less_what_returns, known, guess, epsilon, most_iterations);
}

/// Approaches the fixed point of x = constant + max F (emitted + reflected x). @param take  gets every approximation x
/// with a bound of how much larger the right-hand side is than x
template <class Take>
void approach(const FactorBounds& factors, const VectorXd& reflected, double constant, const VectorXd& emitted,
              double surroundings, double tolerance, Take take) {
    const Index n = factors.low.rows();
    Sparse chosen = factors.low;
    VectorXd values = VectorXd::Zero(n);
    // Each choice is at least as good as the one before; there are finitely many, and a handful is enough.
    constexpr int most_choices = 60;
    for (int i = 0; i < most_choices; ++i) {
        VectorXd radiosity(n + 1);
        radiosity << emitted + reflected.cwiseProduct(values), surroundings;
        choose(factors, radiosity, chosen);
        const VectorXd image = VectorXd::Constant(n, constant) + chosen * radiosity;
        const double growth = (image - values).maxCoeff();
        const double scale = std::max(image.cwiseAbs().maxCoeff(), radiosity.cwiseAbs().maxCoeff());
        take(values, std::max(0.0, growth) + static_cast<double>(n + 1) * epsilon * scale);
        if (i > 0 && growth <= tolerance * scale) return;
        VectorXd known(n + 1);
        known << emitted, surroundings;
        values = fixed_point(chosen, reflected, VectorXd::Constant(n, constant) + chosen * known, image);
        if (!values.allFinite()) values = image;  // the solver broke down: a step is made without it
    }
}

}  // namespace

AbsorptionFound find_absorption(const FactorBounds& factors, const FaceLaws& laws) {
    const Index n = factors.low.rows();
    const auto first_cut_off = [&](const Sparse& shares) {
        const Sparse senders = shares.transpose();
        std::vector<bool> reaches(static_cast<std::size_t>(n));
        std::vector<Index> reached;
        const auto reach = [&](Index i) {
            if (reaches[static_cast<std::size_t>(i)]) return;
            reaches[static_cast<std::size_t>(i)] = true;
            reached.push_back(i);
        };
        const auto reach_from = [&](Index to) {
            for (Sparse::InnerIterator share(senders, to); share; ++share) {
                if (share.value() > 0) reach(share.col());
            }
        };
        for (Index i = 0; i < n; ++i) {
            if (laws.reflected[i] < 1) reach(i);
        }
        reach_from(n);
        while (!reached.empty()) {
            const Index to = reached.back();
            reached.pop_back();
            reach_from(to);
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

FlowBounds::FlowBounds(const FactorBounds& factors, VectorXd reflected)
    : factors_(factors), reflected_(std::move(reflected)) {
    const Index n = factors.low.rows();
    FF_EXPECT(factors.low.cols() == n + 1);
    FF_EXPECT(factors.low.isCompressed() && factors.high.isCompressed());
    FF_EXPECT(factors.low.nonZeros() == factors.high.nonZeros());
    // A w with w >= 1 + F reflected w for all F within the intervals. If x + rest is at least the right-hand side of x,
    // then x + rest w is at least its own, and thus as large as the fixed point. So is the least of several such.
    constexpr double rough = 1e-3;
    spread_ = VectorXd::Constant(n, std::numeric_limits<double>::infinity());
    approach(factors, reflected_, 1, VectorXd::Zero(n), 0, rough, [&](const VectorXd& values, double rest) {
        if (rest < 1) spread_ = spread_.cwiseMin(values / (1 - rest));
    });
}

IrradiationBounds FlowBounds::irradiation(const VectorXd& emitted, double surroundings) const {
    constexpr double fine = 1e-14;
    // The least are the largest of everything negated.
    const auto largest = [&](double sign) {
        VectorXd bound = VectorXd::Constant(spread_.size(), std::numeric_limits<double>::infinity());
        approach(factors_, reflected_, 0, sign * emitted, sign * surroundings, fine,
                 [&](const VectorXd& values, double rest) { bound = bound.cwiseMin(values + rest * spread_); });
        return bound;
    };
    return {-largest(-1), largest(1)};
}

IrradiationBounds bound_irradiation(const FactorBounds& factors, const FaceLaws& laws) {
    FF_EXPECT(find_absorption(factors, laws).absorption == Absorption::reached);
    return FlowBounds(factors, laws.reflected).irradiation(laws.emitted, laws.surroundings);
}

}  // namespace ff
