#pragma once

#include "stats/basics/interval.hpp"
#include "stats/gates/gate_verdict.hpp"

#include <optional>

namespace ff::studies::gates {

using gate::Verdict;

/// The tolerated values of an effect; an end may be infinite.
struct Band {
    double low = 0;
    double high = 0;
    auto operator<=>(const Band&) const = default;

    [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

/// The risks of one comparison at one look.
struct Levels {
    double fail_alpha = 1e-4;  ///< risk of calling an effect outside that lies inside; two-sided, already shared
    double pass_alpha = 0.05;  ///< risk of calling an effect inside that lies at or beyond one end of the band
    double power = 0.9;        ///< power of minimum detectable effects

    /// Levels of the two intervals of a measurement.
    [[nodiscard]] double of_passing() const { return 1 - 2 * pass_alpha; }
    [[nodiscard]] double of_failing() const { return 1 - fail_alpha; }
};

/// A measured effect: its value, and the two intervals that decide.
struct Measurement {
    double value = 0;
    // An infinite limit proves nothing, because the values are too skewed for their number.
    stats::Interval passing;  ///< level 1 - 2 pass_alpha: has to lie inside the band
    stats::Interval failing;  ///< level 1 - fail_alpha: must not lie wholly outside
    /// Effect beyond the band's upper end (its lower one where that is infinite) that fails with the power.
    double minimum_detectable = 0;
};

/// A value with both of its intervals, as `interval_of` makes them from their levels.
template <class IntervalOf>
Measurement measured_at(double value, const Levels& levels, const IntervalOf& interval_of,
                        double minimum_detectable = 0) {
    return {.value = value,
            .passing = interval_of(levels.of_passing()),
            .failing = interval_of(levels.of_failing()),
            .minimum_detectable = minimum_detectable};
}

/// The verdict by the rule of every gate (stats/gates/gate_verdict.hpp); inconclusive without a measurement.
inline Verdict judge(const std::optional<Measurement>& measurement, const Band& band) {
    return measurement ? gate::judge(measurement->passing, measurement->failing, band) : Verdict::inconclusive;
}

/// One verdict for several comparisons: fail if one fails, pass if all pass.
constexpr Verdict together(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::pass && b == Verdict::pass ? Verdict::pass : Verdict::inconclusive;
}

}  // namespace ff::studies::gates
