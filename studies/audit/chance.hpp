#pragma once

#include "studies/audit/scene_facts.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ff::studies::audit {

/// How far chance takes a sum of independent hits from its mean: `z_limit` standard deviations, and a few hits more, as
/// rare hits are not normally distributed (Bernstein's inequality; exp(-z_limit^2 / 2) bounds the risk of each side).
/// @param hit  the most that one hit adds to the sum
double reach_of_chance(double sigma, double hit, double z_limit);

/// Standard deviation of the share of a face's own rays that hit another: of the exact distribution, otherwise an upper
/// bound, that of rays which start anywhere on the face. Patches of equal area make it smaller.
double most_sigma(const SceneFacts& facts, const std::optional<SrDistribution>& distribution, std::uint64_t rays,
                  std::size_t from, std::size_t to);

}  // namespace ff::studies::audit
