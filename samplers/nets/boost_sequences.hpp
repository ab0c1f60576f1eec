#pragma once

#include "samplers/sampler.hpp"

#include <array>

#include <boost/random/niederreiter_base2.hpp>
#include <boost/random/sobol.hpp>

namespace ff::samplers {

/// Fills a block from point `first` on with a quasi-random engine of Boost.Random, keeping the upper 32 of 64 bits.
/// Engines are costly to make and cheap to copy: there is one original for each dimension.
template <class Engine>
void fill_from_engine(PointIndex first, PointBlock& block) {
    static const std::array<Engine, max_dimension> originals{Engine(1), Engine(2), Engine(3), Engine(4)};
    Engine engine = originals[block.dimension - 1];
    engine.seed(first);
    for (std::size_t i = 0; i < block.size; ++i) {
        for (std::size_t d = 0; d < block.dimension; ++d) {
            block.coordinate[d][i] = static_cast<std::uint32_t>(engine() >> 32);
        }
    }
}

/// Niederreiter points in base 2 from Boost.Random, not randomised. @see [niederreiter1988], [bratley1992]
class Niederreiter {
  public:
    static constexpr SamplerInfo info{
        .name = "niederreiter",
        .summary = "Niederreiter points in base 2 as Boost.Random gives them: not randomised, first point skipped",
        .details =
            "boost::random::niederreiter_base2: the digital sequence of Niederreiter (1988) with irreducible "
            "polynomials over GF(2) of degrees 1, 1, 2 and 3, so that t <= 3 in four dimensions, in the order of Gray "
            "code as Bratley, Fox and Niederreiter program it, and without its first point, the origin. Skipping that "
            "point destroys the net: 2^m points are a net with one point exchanged, and for smooth integrands the "
            "error falls as N^-1 only.\n"
            "Not randomised: every trial and every patch has the same points, so there is one estimate, its error is "
            "not known from it, and patches share their errors. It is here for comparison. Any number of points; no "
            "size has the whole net.",
        .reference = "niederreiter1988",
        .sizes = Sizes::any,
        .randomised = false,
        .nanoseconds = 15,
    };

    explicit Niederreiter(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& /*stream*/, PointIndex first, PointBlock& block) const {
        fill_from_engine<boost::random::niederreiter_base2>(first, block);
    }
};

/// Sobol' points from Boost.Random, not randomised. @see [joekuo2008], [owen2022]
class SobolRaw {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_raw",
        .summary = "Sobol' points as Boost.Random gives them: not randomised, first point skipped",
        .details =
            "What many programs use today: boost::random::sobol, with the direction numbers of Joe and Kuo, in the "
            "order of Gray code, and without its first point, the origin. Skipping that point destroys the net: 2^m "
            "points are a net with one point exchanged, and for smooth integrands the error falls as N^-1 where the "
            "whole net, randomised, has N^-3/2 (Owen 2022). Tallies of rays hardly notice.\n"
            "Not randomised: every trial and every patch has the same points, so there is one estimate, its error is "
            "not known from it, and patches share their errors. It is here for comparison; `sobol` is the one to use. "
            "Any number of points; no size has the whole net.",
        .reference = "joekuo2008",
        .sizes = Sizes::any,
        .randomised = false,
        .nanoseconds = 15,
    };

    explicit SobolRaw(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& /*stream*/, PointIndex first, PointBlock& block) const {
        fill_from_engine<boost::random::sobol>(first, block);
    }
};

}  // namespace ff::samplers
