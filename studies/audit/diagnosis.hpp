#pragma once

#include "studies/audit/constraint_system.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies::audit {

/// Suspects whose blame removes every contradiction.
struct Diagnosis {
    std::vector<std::size_t> blamed{};  ///< ascending
    double cost = 0;
    std::vector<Range> ranges{};  ///< [variable]: what all constraints that are not blamed allow
};

/// The cheapest diagnosis first, then others that cost at most half a figure more (at most `most_diagnoses` in total).
/// A consistent system has one empty diagnosis. The first is certain to be cheapest; the search for others gives up
/// early where very many figures contradict each other.
///
/// Minimal sets of figures that contradict each other ("conflicts") are found one by one, and the cheapest set that
/// hits them all is tried until nothing is contradictory any more.
/// @see [reiter1987], [moreno2013]
inline constexpr std::size_t most_diagnoses = 12;

std::vector<Diagnosis> diagnose(const ConstraintSystem& system);

/// A minimal set of unblamed suspects that cannot all be right; empty where there is no contradiction. A system that
/// contradicts itself without any suspect is a bug.
std::vector<std::size_t> find_conflict(const ConstraintSystem& system, const Blame& blame);

}  // namespace ff::studies::audit
