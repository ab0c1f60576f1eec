#pragma once

#include "studies/audit/experiment_model.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace ff::studies::audit {

/// More broken pairs than this cannot be misprints.
inline constexpr std::size_t most_misprints = 12;

/// Adds that area times factor is the same both ways between two faces: unconditionally where rows complete each other;
/// as far as chance allows where every row has its own rays; and as an assumption, which can be given up, where a
/// deterministic method computes both ways, since its own error may be larger than what is printed.
/// @param printed  [variable]: what prints of a pair allow, all together
void add_reciprocity(const std::map<std::size_t, Range>& printed, double z_limit, ExperimentModel& model);

/// The figures that a constraint of reciprocity ties, with the areas of their faces. Congruent pairs share it: one of
/// each is named.
std::string both_ways(const ExperimentModel& model, const Constraint& constraint);

}  // namespace ff::studies::audit
