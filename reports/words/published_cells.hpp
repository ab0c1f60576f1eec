#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <set>
#include <string>

namespace ff::reports {

/// Our value for a printed figure, with as many decimals as a single run's spread warrants (those of the print for a
/// deterministic value) and the range of a single run; "–" where the study has none.
std::string ours_text(const studies::FigureComparison& comparison, const std::string& printed);

/// The position of a printed figure among ours, in words.
std::string place_text(const studies::FigureComparison& comparison, const std::string& printed);

/// Whether a run as described gives the figure less often than `alpha` allows over its whole table.
bool is_surprising(const studies::FigureComparison& comparison, double alpha);

/// The figures that the audit blames for a contradiction.
std::set<std::size_t> blamed_figures(const studies::audit::Report& audit);

}  // namespace ff::reports
