#include "studies/heat/flow_statistics.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/sampled_row.hpp"
#include "studies/heat/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace ff::studies::heat {
namespace {

using Eigen::VectorXd;
using form_factors::FaceExchange;
using form_factors::Matrix;
using form_factors::PairRandomisations;
constexpr std::size_t randomised = form_factors::randomisations;

/// The values behind each exchange; null where it has none.
using ValuesBehind = std::vector<const PairRandomisations*>;

ValuesBehind values_behind(const Matrix& matrix) {
    ValuesBehind behind(matrix.exchanges.size());
    std::size_t next = 0;
    for (const PairRandomisations& values : matrix.randomisations) {
        while (matrix.exchanges[next].from != values.from || matrix.exchanges[next].to != values.to) ++next;
        behind[next] = &values;
    }
    return behind;
}

/// How much a factor changes where one of its randomisations is left out.
double shift_without(const PairRandomisations& values, std::size_t left_out) {
    const double mean = std::accumulate(values.values.begin(), values.values.end(), 0.0) / randomised;
    return (mean - static_cast<double>(values.values.at(left_out))) / (randomised - 1);
}

/// The factors of a matrix, of which some exchanges change: their entries are found once.
class ChangingFactors {
  public:
    explicit ChangingFactors(const Matrix& matrix) : matrix_(matrix), factors_(matrix.factors()) {
        // Exchanges are in order, so that every row gets its columns in order.
        std::vector<int> next(factors_.outerIndexPtr(), factors_.outerIndexPtr() + factors_.rows());
        places_.reserve(matrix.exchanges.size());
        for (const FaceExchange& exchange : matrix.exchanges) {
            const int there = next[exchange.from]++;
            places_.emplace_back(there, exchange.from == exchange.to ? there : next[exchange.to]++);
        }
    }

    void set(std::size_t index, double area) {
        const FaceExchange& exchange = matrix_.exchanges[index];
        const auto [there, back] = places_[index];
        factors_.valuePtr()[there] = area / matrix_.areas[exchange.from];
        factors_.valuePtr()[back] = area / matrix_.areas[exchange.to];
    }
    [[nodiscard]] const Matrix::Sparse& factors() const { return factors_; }

  private:
    const Matrix& matrix_;
    Matrix::Sparse factors_;
    std::vector<std::pair<int, int>> places_;  ///< [exchange]: of its entries, there and back
};

/// The irradiation by the factors of all randomisations, or of all but one; empty where these do not balance.
class Irradiation {
  public:
    /// References are kept.
    Irradiation(const Scene& scene, const Matrix& matrix, const ValuesBehind& behind, const FaceLaws& laws)
        : adds_up_(form_factors::rows_add_up(scene)),
          matrix_(matrix),
          behind_(behind),
          laws_(laws),
          estimates_(matrix),
          guess_(VectorXd::Zero(laws.emitted.size())) {}

    std::optional<VectorXd> from(std::optional<std::size_t> left_out) {
        for (std::size_t i = 0; i < behind_.size(); ++i) {
            if (behind_[i] == nullptr) continue;
            const FaceExchange& exchange = matrix_.exchanges[i];
            const double shift = left_out ? shift_without(*behind_[i], *left_out) : 0;
            estimates_.set(i, std::max(0.0, exchange.value + shift * matrix_.areas[exchange.from]));
        }
        const Matrix::Sparse& factors = estimates_.factors();
        VectorXd irradiation;
        if (adds_up_) {
            const Balanced balanced = form_factors::balance_within(matrix_, factors);
            if (!balanced.balanced) return std::nullopt;
            irradiation = irradiation_of(balanced.factors, VectorXd::Zero(factors.rows()), laws_, guess_);
        } else {
            const VectorXd out = (1 - (factors * VectorXd::Ones(factors.cols())).array()).max(0);
            irradiation = irradiation_of(factors, out, laws_, guess_);
        }
        if (!irradiation.allFinite()) return std::nullopt;
        guess_ = irradiation;
        return irradiation;
    }

  private:
    bool adds_up_;
    const Matrix& matrix_;
    const ValuesBehind& behind_;
    const FaceLaws& laws_;
    ChangingFactors estimates_;
    VectorXd guess_;  ///< the last irradiation, or 0
};

/// Half widths of irradiations that no spread shows, to first order; empty where that is not enough.
/// @param rarer  how many times as much points may miss as at the level of `hidden`
std::optional<VectorXd> hidden_widths(const Sensitivity& sensitivity, const Matrix& matrix, const ValuesBehind& behind,
                                      double rarer) {
    std::vector<double> bounds(behind.size());
    std::vector<double> missed(behind.size());
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const FaceExchange& exchange = matrix.exchanges[i];
        if (behind[i] == nullptr)
            bounds[i] = form_factors::half_width(exchange);
        else
            missed[i] = rarer * static_cast<double>(behind[i]->hidden) * matrix.areas[exchange.from];
    }
    constexpr double rounding = 1e-12;
    constexpr double small = 0.05;  // share of the differences that drive flows
    const VectorXd widths = sensitivity.irradiation_widths(bounds, missed);
    if (!(widths.maxCoeff() <= small * sensitivity.largest_difference() + rounding)) return std::nullopt;
    return widths.array() + rounding * sensitivity.radiosity().cwiseAbs().maxCoeff();
}

/// Values of a quantity, each without one of the randomisations.
using LeftOut = std::array<double, randomised>;

double mean_of(const LeftOut& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / randomised;
}

double standard_error(const LeftOut& values) {
    const double mean = mean_of(values);
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean, 2);
    return std::sqrt((randomised - 1.0) / randomised * squares);
}

/// The interval of a quantity, its bias taken out. @param hidden  what no spread shows, around its estimate
Bounds interval(const Bounds& hidden, const LeftOut& left_out, double critical) {
    const double bias = (randomised - 1) * (mean_of(left_out) - hidden.middle());
    const double half = critical * standard_error(left_out);
    return {hidden.low - bias - half, hidden.high - bias + half};
}

/// Sums over several faces, whose errors depend on each other.
std::vector<Bounds*> sums_of(Flows& flows) {
    std::vector<Bounds*> sums{&flows.balance};
    for (GroupFlow& group : flows.groups) sums.push_back(&group.power);
    return sums;
}

}  // namespace

std::optional<Flows> statistical_flows(const Scene& scene, const Matrix& matrix, const Materials& materials,
                                       double scale, const FlowIntervals& intervals, const FlowsOf& flows_of) {
    if (matrix.randomisations.empty()) return std::nullopt;
    const FaceLaws laws = laws_of(materials);
    const ValuesBehind behind = values_behind(matrix);
    const Sensitivity sensitivity(scene, matrix, materials, scale);
    if (!sensitivity.is_known()) return std::nullopt;
    const double tail = (1 - intervals.level) / 2;
    const std::size_t quantities = matrix.faces() + materials.groups.size() + 1;
    const double smaller = intervals.all_at_once ? tail / static_cast<double>(quantities) : tail;
    // What may be missed grows with this power of the logarithm at most.
    const double rarer = std::pow(std::log(smaller) / std::log(tail), form_factors::UnmetBound{}.power);
    const std::optional<VectorXd> hidden = hidden_widths(sensitivity, matrix, behind, rarer);
    Irradiation irradiation(scene, matrix, behind, laws);
    const std::optional<VectorXd> estimate = irradiation.from(std::nullopt);
    if (!hidden || !estimate) return std::nullopt;
    Flows estimated = flows_of({*estimate - *hidden, *estimate + *hidden});
    const std::vector<Bounds*> sums = sums_of(estimated);
    std::vector<LeftOut> of_faces(matrix.faces());
    std::vector<LeftOut> of_sums(sums.size());
    for (std::size_t r = 0; r < randomised; ++r) {
        const std::optional<VectorXd> without = irradiation.from(r);
        if (!without) return std::nullopt;
        for (std::size_t face = 0; face < of_faces.size(); ++face)
            of_faces[face].at(r) = (*without)[static_cast<Eigen::Index>(face)];
        Flows others = flows_of({*without, *without});
        const std::vector<Bounds*> values = sums_of(others);
        for (std::size_t i = 0; i < values.size(); ++i) of_sums[i].at(r) = values[i]->middle();
    }
    const double critical = stats::student_critical(randomised - 1, smaller);
    // All else about a face follows from its irradiation, which is never negative; shares follow from all faces.
    IrradiationBounds limits{*estimate, *estimate};
    for (std::size_t face = 0; face < of_faces.size(); ++face) {
        const auto row = static_cast<Eigen::Index>(face);
        const auto [low, high] =
            interval({(*estimate - *hidden)[row], (*estimate + *hidden)[row]}, of_faces[face], critical);
        limits.low[row] = std::max(0.0, low);
        limits.high[row] = std::max(0.0, high);
    }
    Flows flows = flows_of(limits);
    const std::vector<Bounds*> wide_sums = sums_of(flows);
    for (std::size_t i = 0; i < sums.size(); ++i) *wide_sums[i] = interval(*sums[i], of_sums[i], critical);
    if (form_factors::rows_add_up(scene)) flows.balance = {};  // with balanced factors as with the true ones
    flows.statistical = true;
    return flows;
}

}  // namespace ff::studies::heat
