#pragma once

#include "core/points/points.hpp"

#include <boost/math/special_functions/legendre.hpp>

#include <vector>

namespace ff::test {

/// Tensor Gauss-Legendre points, made with Boost.Math: so that tests of `core` need no sampler.
class GaussPoints : public PointSource {
  public:
    explicit GaussPoints(int source_nodes, int target_nodes) : exchangeable_(source_nodes == target_nodes) {
        const Rule source = rule(source_nodes);
        const Rule target = rule(target_nodes);
        for (const Node& a : source) {
            for (const Node& b : source) {
                for (const Node& c : target) {
                    for (const Node& d : target) {
                        points_.push_back({{a.at, b.at, c.at, d.at}, a.weight * b.weight * c.weight * d.weight});
                    }
                }
            }
        }
    }

    [[nodiscard]] std::uint64_t points() const override { return points_.size(); }
    [[nodiscard]] bool randomised() const override { return false; }
    [[nodiscard]] bool equal_weights() const override { return false; }
    [[nodiscard]] bool exchangeable() const override { return exchangeable_; }
    /// Hides the symmetry, to compare both ways of using the points.
    void deny_exchangeable() { exchangeable_ = false; }

    void fill(const Stream&, PointIndex, PointBlock&) const override {}
    void fill(const Stream&, PointIndex first, WeightedBlock& block) const override {
        for (std::size_t i = 0; i < block.size; ++i) {
            const Point& point = points_[first + i];
            for (std::size_t d = 0; d < max_dimension; ++d) block.coordinate[d][i] = point.at[d];
            block.weight[i] = point.weight;
        }
    }

  private:
    struct Node {
        double at, weight;
    };
    struct Point {
        std::array<double, 4> at;
        double weight;
    };
    using Rule = std::vector<Node>;

    static Rule rule(int nodes) {
        Rule result;
        for (const double x : boost::math::legendre_p_zeros<double>(nodes)) {  // the non-negative ones
            const double slope = boost::math::legendre_p_prime(nodes, x);
            const double weight = 1 / ((1 - x * x) * slope * slope);
            result.push_back({(1 + x) / 2, weight});
            if (x > 0) result.push_back({(1 - x) / 2, weight});
        }
        return result;
    }

    std::vector<Point> points_;
    bool exchangeable_ = false;
};

}  // namespace ff::test
