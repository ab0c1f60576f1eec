#pragma once

#include "stats/change_point.hpp"
#include "studies/verdicts/history.hpp"

#include "core/points/stream.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// The property of a quantity that may drift.
enum class TrendOf { mean, spread, cost };

std::string_view name(TrendOf what);

/// One series over the commits of a history, and the change of its level.
struct Trend {
    std::string quantity;
    TrendOf what = TrendOf::mean;
    std::vector<std::string> commits;
    std::vector<double> values;
    std::vector<double> errors;                ///< of means; else empty
    std::optional<stats::ChangePoint> change;  ///< the largest, significant or not
    double adjusted_p = 1;                     ///< Holm, over all series of the history
    bool changed = false;
    std::string note;  ///< why it was not tested; empty if it was
};

struct TrendOptions {
    double alpha = 0.01;  ///< of a change anywhere in the history, where there is none
    Seed seed{1};         ///< of the permutations
};

/// Means, spreads and costs of all quantities. Spreads and costs are tested by their logarithms. A series is not tested
/// where it is too short for any change to be found, or where n differs between its runs by more than a fifth: then its
/// orders are not equally likely.
std::vector<Trend> find_trends(const History& history, const TrendOptions& options);

}  // namespace ff::studies
