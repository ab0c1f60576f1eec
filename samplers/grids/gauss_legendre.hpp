#pragma once

#include "samplers/sampler.hpp"

#include <vector>

namespace ff::samplers {

/// Nodes in (0, 1), ascending, and weights that sum to 1: exact for polynomials up to degree 2n - 1.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

/// The Gauss-Legendre rule with `nodes` nodes, correct to the last bit or two. @pre 1 <= nodes <= 64
GaussRule gauss_rule(std::uint32_t nodes);

/// Tensor product of Gauss-Legendre rules: n1 nodes per side on the source patch, n2 on the target patch. @see
/// [davis1984]
class GaussLegendre {
  public:
    static constexpr std::uint32_t max_nodes = 64;

    static constexpr SamplerInfo info{
        .name = "gauss_legendre",
        .summary = "tensor Gauss-Legendre nodes with weights (not random)",
        .details =
            "The product of one-dimensional Gauss-Legendre rules: n1 nodes a side on the source patch (coordinates 0 "
            "and 1), n2 on the target patch (2 and 3), n1^2 n2^2 points in all, the last coordinate fastest. Exact for "
            "polynomials up to degree 2n - 1 in each coordinate; nodes and weights are right to double precision.\n"
            "Sizes: 1 to 64 nodes a side, `nodes = 5` or `nodes = [5, 6]`. Points have weights, so they cannot be "
            "tallied as rays; and there is nothing random in them, so one trial says all and no interval exists. With "
            "`area_kernel` this is the deterministic method PDM. Known trap: on patches that share an edge the "
            "integrand is singular and the error falls only as 1/n^2, with a constant that nodes facing each other "
            "squarely across the edge make large; different n1 and n2 avoid that at no cost.",
        .reference = "davis1984",
        .sizes = Sizes::nodes,
        .randomised = false,
        .equal_weights = false,
    };

    /// @throws UserError unless the numbers of nodes are 1 to 64
    explicit GaussLegendre(const PointSetSpec& spec);

    [[nodiscard]] std::uint64_t points() const;
    [[nodiscard]] bool exchangeable() const;
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const;

  private:
    std::vector<GaussRule> rules_;  ///< one per coordinate
};

}  // namespace ff::samplers
