#include "samplers/grids/gauss_legendre.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace ff::samplers {
namespace {

constexpr std::size_t source_coordinates = 2;

void require_nodes(std::uint32_t nodes, const char* patch) {
    if (nodes >= 1 && nodes <= GaussLegendre::max_nodes) return;
    throw UserError("{} nodes a side on the {} patch (gauss_legendre has rules of 1 to {} nodes). Try 5.", nodes, patch,
                    GaussLegendre::max_nodes);
}

/// 1 / ((1 - x^2) P_n'(x)^2): half the weight on [-1, 1].
double weight_at(std::uint32_t n, long double x) {
    const long double slope = boost::math::legendre_p_prime(static_cast<int>(n), x);
    return static_cast<double>(1 / ((1 - x) * (1 + x) * slope * slope));
}

}  // namespace

GaussRule gauss_rule(std::uint32_t nodes) {
    FF_EXPECT(nodes >= 1 && nodes <= GaussLegendre::max_nodes);
    // The zeros x >= 0 of P_n in ascending order; the others are their mirror images.
    const auto zeros = boost::math::legendre_p_zeros<long double>(static_cast<int>(nodes));
    GaussRule rule{std::vector<double>(nodes), std::vector<double>(nodes)};
    for (std::size_t i = 0; i < zeros.size(); ++i) {
        const std::size_t low = zeros.size() - 1 - i;
        const std::size_t high = nodes - 1 - low;
        rule.nodes[low] = static_cast<double>((1 - zeros[i]) / 2);
        rule.nodes[high] = static_cast<double>((1 + zeros[i]) / 2);
        rule.weights[low] = rule.weights[high] = weight_at(nodes, zeros[i]);
    }
    return rule;
}

GaussLegendre::GaussLegendre(const PointSetSpec& spec) {
    for (std::size_t d = 0; d < spec.dimension; ++d) {
        const bool on_source = d < source_coordinates;
        const std::uint32_t nodes = on_source ? spec.source_nodes : spec.target_nodes;
        require_nodes(nodes, on_source ? "source" : "target");
        rules_.push_back(gauss_rule(nodes));
    }
}

std::uint64_t GaussLegendre::points() const {
    std::uint64_t points = 1;
    for (const GaussRule& rule : rules_) points *= rule.nodes.size();
    return points;
}

bool GaussLegendre::exchangeable() const {
    return rules_.size() == max_dimension && rules_.front().nodes.size() == rules_.back().nodes.size();
}

void GaussLegendre::fill(const Stream& /*stream*/, PointIndex first, WeightedBlock& block) const {
    FF_EXPECT(block.dimension == rules_.size());
    for (std::size_t i = 0; i < block.size; ++i) {
        PointIndex rest = first + i;
        double weight = 1;
        for (std::size_t d = block.dimension; d-- > 0;) {
            const GaussRule& rule = rules_[d];
            const std::size_t digit = rest % rule.nodes.size();
            rest /= rule.nodes.size();
            block.coordinate[d][i] = rule.nodes[digit];
            weight *= rule.weights[digit];
        }
        block.weight[i] = weight;
    }
}

}  // namespace ff::samplers
