#pragma once

#include "studies/audit/constraint_system.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// Suspects whose blame removes every contradiction.
struct Diagnosis {
    std::vector<std::size_t> blamed{};  ///< ascending
    double cost = 0;
    std::vector<Range> ranges{};  ///< of the variables, from everything that is not blamed
};

/// The cheapest diagnosis first, then the alternatives: for every suspect in it, the cheapest diagnosis that leaves
/// this one alone, where it blames no more than half a figure more. A consistent system has one empty diagnosis.
///
/// Minimal sets of figures that contradict each other ("conflicts") are found one by one, and the cheapest set that
/// hits them all is tried until nothing is contradictory any more.
/// @see [reiter1987], [moreno2013]
std::vector<Diagnosis> diagnose(const ConstraintSystem& system);

/// A minimal set of suspects that cannot all be right, among those not blamed; empty where there is no contradiction.
/// A system that contradicts itself without any suspect is a bug.
std::vector<std::size_t> find_conflict(const ConstraintSystem& system, const Blame& blame);

}  // namespace ff::studies
