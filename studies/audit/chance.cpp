#include "studies/audit/chance.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::audit {

double reach_of_chance(double sigma, double hit, double z_limit) {
    const double few = z_limit * z_limit * hit / 6;
    return few + std::hypot(few, z_limit * sigma);
}

double most_sigma(const SceneFacts& facts, const std::optional<SrDistribution>& distribution, std::uint64_t rays,
                  std::size_t from, std::size_t to) {
    if (distribution) return distribution->pair_sigma(static_cast<int>(from), static_cast<int>(to));
    const Range factor = facts.factor(from, to);
    const double worst = std::clamp(0.5, factor.low, factor.high);
    return std::sqrt(worst * std::max(0.0, 1 - worst) / static_cast<double>(rays));
}

}  // namespace ff::studies::audit
