#include "studies/theory/expected_rate.hpp"

#include "samplers/sampler.hpp"

#include <cmath>

namespace ff::studies {
namespace {

using samplers::Spread;

/// What a sampler integrates, as theories tell integrands apart.
enum class Integrand {
    jumping,  ///< smooth but for jumps at curved boundaries that are parallel to no axis: the rays that hit, the kernel
              ///< of points that see each other
    smooth,
    rough,      ///< of finite variance, but no theory of smooth or of jumping functions holds
    unbounded,  ///< with tail index 3/2
};

std::optional<Integrand> integrand_of(const Method& method, PairClass pair_class, Hiding hiding) {
    if (pair_class == PairClass::other) return std::nullopt;
    const bool adjacent = pair_class == PairClass::adjacent;
    switch (method.estimator) {
        case Estimator::ray_shooting:
            return Integrand::jumping;
        case Estimator::area_kernel:
            if (adjacent)
                return method.map == PointMap::graded && hiding == Hiding::none ? Integrand::rough
                                                                                : Integrand::unbounded;
            return hiding == Hiding::possible ? Integrand::jumping : Integrand::smooth;
        case Estimator::point_to_polygon:
            return adjacent ? Integrand::rough : Integrand::smooth;
        case Estimator::closed_form:
            break;
    }
    return std::nullopt;
}

std::optional<ExpectedRate> rate_of_grid(Integrand integrand, double dimension) {
    switch (integrand) {
        case Integrand::jumping:
            return ExpectedRate{
                .rate = -0.5 - 0.5 / dimension, .source = "heowen2016", .because = "jittered points, jumps"};
        case Integrand::smooth:
            return ExpectedRate{
                .rate = -0.5 - 1 / dimension, .source = "heowen2016", .because = "jittered points, Lipschitz"};
        case Integrand::rough:
        case Integrand::unbounded:
            break;
    }
    return std::nullopt;
}

std::optional<ExpectedRate> rate_of_net(Integrand integrand, double dimension) {
    switch (integrand) {
        case Integrand::jumping:
            return ExpectedRate{.rate = -0.5 - 1 / (4 * dimension - 2),
                                .at_least = true,
                                .source = "hewang2015",
                                .because = "scrambled net, jumps"};
        case Integrand::smooth:
            return ExpectedRate{.rate = -1.5,
                                .log_power = (dimension - 1) / 2,
                                .source = "owen1997b",
                                .because = "scrambled net, smooth"};
        case Integrand::rough:
        case Integrand::unbounded:
            break;
    }
    return std::nullopt;
}

/// Every unbiased rule of finite variance whose parts do not know of each other.
ExpectedRate root_of_size(std::string_view source, std::string_view because) {
    return {.rate = -0.5, .source = source, .because = because};
}

}  // namespace

double ExpectedRate::slowest(double size) const {
    return rate + log_power / std::log(size);
}

std::optional<ExpectedRate> expected_rate(const Method& method, PairClass pair_class, Hiding hiding) {
    const double d = static_cast<double>(dimension(method.estimator));
    const auto integrand = integrand_of(method, pair_class, hiding);
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
            if (dimension(method.estimator) == 2) return rate_of_net(*integrand, d);  // one net is all there is
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
