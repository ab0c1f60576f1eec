#include "stats/skewed_mean.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"

namespace ff::stats {

SkewedReach reach_of_mean(std::span<const double> values, double effective, double freedom, double tail) {
    FF_EXPECT(values.size() >= 3 && effective >= 2 && freedom > 0 && 0 < tail && tail < 0.5);
    return gate::skewed_reach(gate::skewness_of(values, effective), effective, student_critical(freedom, tail));
}

}  // namespace ff::stats
