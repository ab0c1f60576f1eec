#include "studies/theory/expected_rate.hpp"

#include "samplers/sampler.hpp"

#include <cmath>

namespace ff::studies {
namespace {

using samplers::Spread;

std::optional<ExpectedRate> rate_of_grid(Integrand integrand, double dimension) {
    if (integrand == Integrand::jumping)
        return ExpectedRate{
            .rate = -0.5 - 0.5 / dimension, .source = "heowen2016", .because = "jittered points, jumps"};
    if (integrand != Integrand::smooth) return std::nullopt;
    return ExpectedRate{.rate = -0.5 - 1 / dimension, .source = "heowen2016", .because = "jittered points, Lipschitz"};
}

std::optional<ExpectedRate> rate_of_net(Integrand integrand, double dimension) {
    if (integrand == Integrand::jumping)
        return ExpectedRate{.rate = -0.5 - 1 / (4 * dimension - 2),
                            .at_least = true,
                            .source = "hewang2015",
                            .because = "scrambled net, jumps"};
    if (integrand != Integrand::smooth) return std::nullopt;
    return ExpectedRate{
        .rate = -1.5, .log_power = (dimension - 1) / 2, .source = "owen1997b", .because = "scrambled net, smooth"};
}

/// The rate of every unbiased rule with finite variance whose parts are independent of each other.
ExpectedRate root_of_size(std::string_view source, std::string_view because) {
    return {.rate = -0.5, .source = source, .because = because};
}

}  // namespace

double ExpectedRate::slowest(double size) const {
    if (of_median) return 0;
    return rate + log_power / std::log(size);
}

std::optional<ExpectedRate> expected_rate(const Method& method, PairClass pair_class, Hiding hiding) {
    const EstimatorEntry& estimator = find_estimator(method.estimator);
    const double d = static_cast<double>(estimator.info.dimension);
    if (pair_class == PairClass::other) return std::nullopt;
    const auto integrand = estimator.integrand(estimator_options(method), pair_class, hiding);
    if (!integrand) return std::nullopt;
    const Spread spread = samplers::find(method.sampler).info.spread;
    if (*integrand == Integrand::unbounded) {
        if (spread != Spread::independent) return std::nullopt;
        // The mean of values with tail index a < 2 is off by about N^(1/a - 1).
        return ExpectedRate{.rate = -1.0 / 3,
                            .of_median = true,
                            .source = "feller1971",
                            .because = "independent points, tail index 3/2"};
    }
    switch (spread) {
        case Spread::independent:
        case Spread::mirrored:
            return root_of_size("owen2013", "independent points");
        case Spread::latin:
            return root_of_size("stein1987", "only sums of functions of one coordinate gain");
        case Spread::grid:
            return rate_of_grid(*integrand, d);
        case Spread::net:
            return rate_of_net(*integrand, d);
        case Spread::padded_nets:
            if (estimator.info.dimension == 2) return rate_of_net(*integrand, d);  // one net is all there is
            return root_of_size("owen1998", "only sums of functions of one pair of coordinates gain");
        case Spread::halton:
        case Spread::lattice:
            if (*integrand != Integrand::smooth) return std::nullopt;
            return ExpectedRate{.rate = -1,
                                .log_power = d,
                                .at_least = true,
                                .source = spread == Spread::halton ? "niederreiter1992" : "sloan2002",
                                .because = "low discrepancy, bounded variation"};
        case Spread::other:
            break;
    }
    return std::nullopt;
}

}  // namespace ff::studies
