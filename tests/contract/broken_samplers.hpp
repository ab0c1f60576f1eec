#pragma once

#include "samplers/grids/gauss_legendre.hpp"
#include "samplers/grids/stratified.hpp"
#include "samplers/nets/sobol.hpp"
#include "samplers/random/random.hpp"
#include "samplers/support/entry.hpp"

// Samplers that are broken on purpose, each in one way, beside the controls that the program ships. The contract checks
// must catch every one.

namespace ff::test {

/// One coordinate prefers small values, by 6 %.
struct BiasedCoordinate : samplers::Random {
    using Random::Random;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        Random::fill(stream, first, block);
        for (std::uint32_t& x : block.coordinate[2]) {
            if ((x & 15u) == 0) x /= 2;
        }
    }
};

struct EqualCoordinates : samplers::Random {
    using Random::Random;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        Random::fill(stream, first, block);
        block.coordinate[3] = block.coordinate[1];
    }
};

struct SameForEverySource : samplers::Random {
    using Random::Random;
    void fill(Stream stream, PointIndex first, PointBlock& block) const {
        stream.source = 0;
        Random::fill(stream, first, block);
    }
};

/// Trials 2k and 2k + 1 are mirror images: "replicates" that share a state.
struct CorrelatedTrials : samplers::Random {
    using Random::Random;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        Random::fill({.key = stream.key, .trial = stream.trial / 2}, first, block);
        if (stream.trial % 2 == 0) return;
        for (auto& row : block.coordinate) {
            for (std::uint32_t& x : row) x = ~x;
        }
    }
};

/// Large coordinates are missing: every integral of the smooth kind is off by some percent.
struct ShrunkCoordinate : samplers::Random {
    using Random::Random;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        Random::fill(stream, first, block);
        for (std::uint32_t& x : block.coordinate[0]) x -= x / 8;
    }
};

/// The same points in every stream.
struct FixedPoints : samplers::Random {
    using Random::Random;
    void fill(const Stream& /*stream*/, PointIndex first, PointBlock& block) const { Random::fill({}, first, block); }
};

/// Numbered within the block: a second block repeats the first.
struct NumberedByBlock : samplers::Random {
    using Random::Random;
    void fill(const Stream& stream, PointIndex /*first*/, PointBlock& block) const { Random::fill(stream, 0, block); }
};

/// Sobol' points that claim to be independent.
struct FalselyIndependent : samplers::Sobol {
    static constexpr samplers::SamplerInfo info{.name = "falsely_independent",
                                                .summary = "",
                                                .details = "",
                                                .reference = "",
                                                .sizes = samplers::Sizes::powers,
                                                .spread = samplers::Spread::independent};
    using Sobol::Sobol;
};

/// Jittered points whose cells overlap.
struct OverlappingCells : samplers::Stratified {
    using Stratified::Stratified;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        Stratified::fill(stream, first, block);
        for (std::uint32_t& x : block.coordinate[1]) x += 1u << 28;
    }
};

/// Weights that belong to [-1, 1].
struct DoubledWeights : samplers::GaussLegendre {
    using GaussLegendre::GaussLegendre;
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const {
        GaussLegendre::fill(stream, first, block);
        for (std::size_t i = 0; i < block.size; ++i) block.weight[i] *= 2;
    }
};

/// Equal weights at Gauss-Legendre nodes.
struct WeightsForgotten : samplers::GaussLegendre {
    using GaussLegendre::GaussLegendre;
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const {
        GaussLegendre::fill(stream, first, block);
        for (std::size_t i = 0; i < block.size; ++i) block.weight[i] = 1.0 / static_cast<double>(points());
    }
};

}  // namespace ff::test
