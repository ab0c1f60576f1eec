#include "studies/heat/flow_statistics.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/form_factors/amendments.hpp"
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

/// The irradiation by the factors of all randomisations, or of all but one; empty where these do not balance.
class Irradiation {
  public:
    /// References are kept.
    Irradiation(const Scene& scene, const Matrix& matrix, const ValuesBehind& behind, const FaceLaws& laws)
        : adds_up_(form_factors::rows_add_up(scene)), matrix_(matrix), behind_(behind), laws_(laws) {
        estimates_.areas = matrix.areas;
        estimates_.exchanges = matrix.exchanges;
    }

    std::optional<VectorXd> from(std::optional<std::size_t> left_out) {
        for (std::size_t i = 0; i < behind_.size(); ++i) {
            if (behind_[i] == nullptr) continue;
            const FaceExchange& exchange = matrix_.exchanges[i];
            const double shift = left_out ? shift_without(*behind_[i], *left_out) : 0;
            estimates_.exchanges[i].value = std::max(0.0, exchange.value + shift * matrix_.areas[exchange.from]);
        }
        Matrix::Sparse factors = estimates_.factors();
        VectorXd out = VectorXd::Zero(factors.rows());
        if (adds_up_) {
            Balanced balanced = form_factors::balance_within(matrix_, factors);
            if (!balanced.balanced) return std::nullopt;
            factors = std::move(balanced.factors);
        } else {
            out = (1 - (factors * VectorXd::Ones(factors.cols())).array()).max(0);
        }
        VectorXd irradiation = irradiation_of(factors, out, laws_);
        return irradiation.allFinite() ? std::optional(std::move(irradiation)) : std::nullopt;
    }

  private:
    bool adds_up_;
    const Matrix& matrix_;
    const ValuesBehind& behind_;
    const FaceLaws& laws_;
    Matrix estimates_;
};

/// Half widths of irradiations that no spread shows, to first order; empty where that is not enough.
std::optional<VectorXd> hidden_widths(const Sensitivity& sensitivity, const Matrix& matrix,
                                      const ValuesBehind& behind) {
    std::vector<double> bounds(behind.size());
    std::vector<double> missed(behind.size());
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const FaceExchange& exchange = matrix.exchanges[i];
        if (behind[i] == nullptr)
            bounds[i] = form_factors::half_width(exchange);
        else
            missed[i] = static_cast<double>(behind[i]->hidden) * matrix.areas[exchange.from];
    }
    constexpr double rounding = 1e-12;
    constexpr double small = 0.05;  // share of the differences that drive flows
    const VectorXd& radiosity = sensitivity.radiosity();
    const VectorXd widths = sensitivity.irradiation_widths(bounds, missed);
    if (!(widths.maxCoeff() <= small * (radiosity.maxCoeff() - radiosity.minCoeff()) + rounding)) return std::nullopt;
    return widths.array() + rounding * radiosity.cwiseAbs().maxCoeff();
}

/// All limits of flows, in order; null where a group has no share.
std::vector<Bounds*> quantities(Flows& flows) {
    std::vector<Bounds*> all;
    for (FaceFlow& face : flows.faces)
        all.insert(all.end(), {&face.radiosity, &face.irradiation, &face.net, &face.power, &face.temperature});
    for (GroupFlow& group : flows.groups) all.insert(all.end(), {&group.power, group.share ? &*group.share : nullptr});
    all.push_back(&flows.balance);
    return all;
}

/// Values of a quantity, each without one of the randomisations.
struct LeftOut {
    std::array<double, randomised> values{};

    [[nodiscard]] double mean() const { return std::accumulate(values.begin(), values.end(), 0.0) / randomised; }
    [[nodiscard]] double standard_error() const {
        double squares = 0;
        for (const double value : values) squares += std::pow(value - mean(), 2);
        return std::sqrt((randomised - 1.0) / randomised * squares);
    }
};

}  // namespace

std::optional<Flows> statistical_flows(const Scene& scene, const Matrix& matrix, const Materials& materials,
                                       double scale, const FlowIntervals& intervals, const FlowsOf& flows_of) {
    if (matrix.randomisations.empty()) return std::nullopt;
    const FaceLaws laws = laws_of(materials);
    const ValuesBehind behind = values_behind(matrix);
    const Sensitivity sensitivity(scene, matrix, materials, scale);
    if (!sensitivity.is_known()) return std::nullopt;
    const std::optional<VectorXd> hidden = hidden_widths(sensitivity, matrix, behind);
    Irradiation irradiation(scene, matrix, behind, laws);
    const std::optional<VectorXd> estimate = irradiation.from(std::nullopt);
    if (!hidden || !estimate) return std::nullopt;
    Flows flows = flows_of({*estimate - *hidden, *estimate + *hidden});
    const std::vector<Bounds*> limits = quantities(flows);
    std::vector<LeftOut> left_out(limits.size());
    for (std::size_t r = 0; r < randomised; ++r) {
        const std::optional<VectorXd> without = irradiation.from(r);
        if (!without) return std::nullopt;
        Flows others = flows_of({*without, *without});
        const std::vector<Bounds*> values = quantities(others);
        for (std::size_t i = 0; i < limits.size(); ++i)
            left_out[i].values.at(r) = values[i] == nullptr ? std::nan("") : values[i]->middle();
    }
    const auto uncertain = std::ranges::count_if(left_out, [](const LeftOut& one) { return one.standard_error() > 0; });
    const double tail = (1 - intervals.level) / 2 /
                        (intervals.all_at_once ? static_cast<double>(std::max<std::ptrdiff_t>(1, uncertain)) : 1);
    const double critical = stats::student_critical(randomised - 1, tail);
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (limits[i] == nullptr) continue;
        const double bias = (randomised - 1) * (left_out[i].mean() - limits[i]->middle());
        const double half = critical * left_out[i].standard_error();
        *limits[i] = {limits[i]->low - bias - half, limits[i]->high - bias + half};
    }
    for (GroupFlow& group : flows.groups) {
        if (group.share && std::isnan(group.share->low)) group.share.reset();
    }
    if (form_factors::rows_add_up(scene)) flows.balance = {};  // with balanced factors as with the true ones
    flows.statistical = true;
    return flows;
}

}  // namespace ff::studies::heat
