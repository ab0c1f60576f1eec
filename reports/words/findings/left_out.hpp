#pragma once

#include "reports/words/findings/standing.hpp"

#include <cstddef>
#include <string>

namespace ff::reports {

// What rankings do not compare, as a sentence; empty where that is nothing.

/// Errors on some pairs of a scene, which have no variance.
std::string which_variances_are_left_out(const studies::Analysis& findings, std::size_t scene);

/// The same, or else methods that have no size in common with those of the ranking.
/// @param ranking  of errors
std::string which_errors_are_left_out(const studies::Analysis& findings, const Ranking& ranking);

}  // namespace ff::reports
