#include "studies/heat/flow_sampling.hpp"
#include "studies/heat/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace ff::studies::heat {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool has_choice(const form_factors::FaceExchange& pair) {
    return pair.is_sampled() || pair.method == ExchangeMethod::bounds;
}

/// Groups of pairs that are sampled together: those of a face by the rays that leave it; each other pair by itself.
struct Groups {
    std::vector<std::size_t> of;  ///< [pair]: index of its group
    std::vector<double> samples;  ///< [group]: number of its samples

    /// The largest value of each group. @param values  one for each pair
    [[nodiscard]] std::vector<double> largest(const std::vector<double>& values) const {
        std::vector<double> result(samples.size());
        for (std::size_t p = 0; p < of.size(); ++p) result[of[p]] = std::max(result[of[p]], values[p]);
        return result;
    }
};

Groups groups_of(const form_factors::Matrix& matrix) {
    constexpr double least = 128;  // samples of pairs that were not sampled yet
    Groups groups;
    std::map<std::uint32_t, std::size_t> by_rays;
    for (const form_factors::FaceExchange& pair : matrix.exchanges) {
        const std::uint32_t smaller = matrix.areas[pair.to] < matrix.areas[pair.from] ? pair.to : pair.from;
        std::size_t group = groups.samples.size();
        if (pair.method == ExchangeMethod::rays) group = by_rays.try_emplace(smaller, group).first->second;
        if (group == groups.samples.size()) groups.samples.push_back(0);
        groups.of.push_back(group);
        groups.samples[group] =
            std::max({groups.samples[group], has_choice(pair) ? least : 0, static_cast<double>(pair.samples)});
    }
    return groups;
}

/// Samples grow with this power of 1 / half width, as measured for a series of tolerances: for cells and points in the
/// room with a block of docs/scenes.md, for rays in an annulus.
double growth(const form_factors::FaceExchange& pair) {
    constexpr double of_cells = 0.15;
    constexpr double of_points = 0.66;
    constexpr double of_rays = 1.33;
    return pair.method == ExchangeMethod::rays ? of_rays : pair.method == ExchangeMethod::cells ? of_cells : of_points;
}

/// Half widths of exchange areas that minimise the samples for powers of these weights, up to a common factor.
struct Allocation {
    std::vector<double> shape;
    std::vector<double> least, most;

    [[nodiscard]] std::vector<double> at(double factor) const {
        std::vector<double> result;
        for (std::size_t p = 0; p < shape.size(); ++p)
            result.push_back(std::clamp(factor * shape[p], least[p], std::max(least[p], most[p])));
        return result;
    }
};

/// Makes the widest power as wide as the target, or as near as the limits allow.
std::vector<double> scaled(const Sensitivity& sensitivity, const Allocation& allocation, double target) {
    constexpr int steps = 8;
    double factor = 1;
    std::vector<double> result = allocation.at(factor);
    for (int i = 0; i < steps; ++i) {
        const double width = sensitivity.widths(result).maxCoeff();
        if (!(width > 0)) break;
        factor *= target / width;
        result = allocation.at(factor);
    }
    return result;
}

}  // namespace

std::optional<FlowPlan> plan_flows(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials,
                                   double scale, const FlowTolerance& tolerance, double floor) {
    const Sensitivity sensitivity(scene, matrix, materials, scale);
    if (!sensitivity.is_known() || matrix.exchanges.empty()) return std::nullopt;
    const double target = tolerance.power(sensitivity.throughput());
    const Groups groups = groups_of(matrix);
    const std::size_t pairs = matrix.exchanges.size();
    Allocation allocation{std::vector<double>(pairs), std::vector<double>(pairs), std::vector<double>(pairs)};
    for (std::size_t p = 0; p < pairs; ++p) {
        const form_factors::FaceExchange& pair = matrix.exchanges[p];
        if (!has_choice(pair)) continue;
        allocation.most[p] = form_factors::half_width(pair);
        allocation.least[p] = floor * matrix.smaller_area(pair);
    }
    const auto cost_of = [&](const std::vector<double>& half_widths) {
        std::vector<double> growths(pairs);
        for (std::size_t p = 0; p < pairs; ++p) {
            if (half_widths[p] > 0)
                growths[p] = std::pow(allocation.most[p] / half_widths[p], growth(matrix.exchanges[p]));
        }
        const std::vector<double> growth_of_group = groups.largest(growths);
        return std::inner_product(groups.samples.begin(), groups.samples.end(), growth_of_group.begin(), 0.);
    };
    // One tolerance for all factors comes first. The costs of plans are estimates, and measured ones were often higher:
    // a plan has to promise half of it.
    constexpr double worth = 0.5;
    double widest = 0;  // factor
    for (std::size_t p = 0; p < pairs; ++p)
        widest = std::max(widest, allocation.most[p] / matrix.smaller_area(matrix.exchanges[p]));
    for (std::size_t p = 0; p < pairs; ++p)
        allocation.shape[p] = has_choice(matrix.exchanges[p]) ? widest * matrix.smaller_area(matrix.exchanges[p]) : 0;
    std::vector<double> best = scaled(sensitivity, allocation, target);
    FlowPlan plan{.tolerances = {}, .even = true};
    double least_cost = worth * cost_of(best);
    VectorXd weights = VectorXd::Ones(sensitivity.absorbing().size());
    constexpr int rounds = 8;
    for (int i = 0; i < rounds; ++i) {
        const std::vector<double> importance = sensitivity.importance(weights);
        std::vector<double> widths_now(groups.samples.size());  // sum that each group adds to the weighted powers
        for (std::size_t p = 0; p < pairs; ++p) widths_now[groups.of[p]] += importance[p] * allocation.most[p];
        for (std::size_t p = 0; p < pairs; ++p) {
            const std::size_t group = groups.of[p];
            const double share = widths_now[group] > 0 ? std::sqrt(groups.samples[group] / widths_now[group]) : 1;
            allocation.shape[p] = share * allocation.most[p];
        }
        const std::vector<double> half_widths = scaled(sensitivity, allocation, target);
        const double cost = cost_of(half_widths);
        if (cost < least_cost) {
            least_cost = cost;
            best = half_widths;
            plan.even = false;
        }
        const VectorXd widths = sensitivity.widths(half_widths);
        if (!(widths.maxCoeff() > 0)) break;
        weights = weights.cwiseProduct(widths / widths.maxCoeff());
    }
    for (std::size_t p = 0; p < pairs; ++p) best[p] /= matrix.smaller_area(matrix.exchanges[p]);
    if (plan.even) {
        const double narrowest = *std::ranges::max_element(best);
        plan.tolerances.assign(pairs, narrowest);
        return plan;
    }
    // Rays for the widest pair of a face make the others as narrow as they have to be; asked for each, chance would
    // have the pair decide whose pilot was the narrowest.
    const std::vector<double> of_group = groups.largest(best);
    for (std::size_t p = 0; p < pairs; ++p) plan.tolerances.push_back(of_group[groups.of[p]]);
    return plan;
}

}  // namespace ff::studies::heat
