#pragma once

#include "core/visibility/pair_class.hpp"
#include "studies/spec/spec.hpp"

#include <optional>
#include <string_view>

namespace ff::studies {

/// The error of a sampler with N points in theory: N^rate (ln N)^log_power.
struct ExpectedRate {
    double rate = 0;
    double log_power = 0;      ///< largest power of the logarithm; 0 where there are no logarithms
    bool at_least = false;     ///< an upper bound of the error: it may fall faster
    bool of_median = false;    ///< the rate is that of the median absolute error; the RMSE does not exist
    std::string_view source;   ///< key of docs/references.md
    std::string_view because;  ///< the reason in a few words

    /// The slowest expected slope of a straight line through sizes about `size`: that of N^rate (ln N)^log_power
    /// there. Rates of medians are limits [hall1981], and how soon they are approached depends on the scene: any slope
    /// from 0 on may precede them.
    [[nodiscard]] double slowest(double size) const;
};

/// The rate for one patch, or a fixed number of them, on each face. Empty where no theory is known.
/// @see docs/convergence.md for the table
std::optional<ExpectedRate> expected_rate(const Method& method, PairClass pair_class, Hiding hiding = Hiding::none);

}  // namespace ff::studies
