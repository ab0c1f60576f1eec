#pragma once

#include "studies/audit/constraint_system.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies::audit {

/// Suspects whose blame removes every contradiction.
struct Diagnosis {
    std::vector<std::size_t> blamed{};  ///< ascending
    double cost = 0;
    std::vector<Range> ranges{};  ///< [variable]: what all constraints that are not blamed allow
    /// Whether no cheaper diagnosis exists; otherwise each of the blamed is needed, but other suspects might explain
    /// everything with fewer.
    bool proven = true;
};

/// The cheapest diagnosis first, then others that cost at most half a figure more (at most `most_diagnoses` in total).
/// A consistent system has one empty diagnosis. The search for others gives up early where very many figures contradict
/// each other; where even the first cannot be proven cheapest in some seconds, it is the only one.
///
/// Minimal sets of figures that contradict each other ("conflicts") are found one by one, and the cheapest set that
/// hits them all is tried until nothing is contradictory any more.
/// @see [reiter1987], [moreno2013]
inline constexpr std::size_t most_diagnoses = 12;

std::vector<Diagnosis> diagnose(const ConstraintSystem& system);

/// The cheapest diagnosis if it costs at most `limit`, without a search for others.
std::optional<Diagnosis> find_cheapest(const ConstraintSystem& system, double limit);

/// A minimal set of unblamed suspects that cannot all be right; empty where there is no contradiction. A system that
/// contradicts itself without any suspect is a bug.
std::vector<std::size_t> find_conflict(const ConstraintSystem& system, const Blame& blame);

}  // namespace ff::studies::audit
