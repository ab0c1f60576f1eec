#include "studies/gates/estimate_gates.hpp"

#include "core/contract.hpp"
#include "core/error.hpp"
#include "stats/repeats.hpp"
#include "stats/serial_correlation.hpp"
#include "stats/spread.hpp"
#include "stats/tail_index.hpp"
#include "studies/gates/measurement.hpp"
#include "studies/gates/needed_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

constexpr double repeat_alpha = 1e-6;
constexpr double serial_alpha = 0.05;
constexpr double tail_alpha = 0.005;  // of each tail
constexpr double largest_vov = 0.1;   // of a healthy mean [pederson1997]
constexpr std::size_t fewest_for_tails = 200;
constexpr std::size_t enough_for_tails = 1000;  // to show that a tail as light as the exponential one has a variance
constexpr double light_alpha = 0.05;            // of calling one finite that is not

[[noreturn]] void refuse(const EstimateSeries& series, const std::string& origin, std::size_t index,
                         const std::string& problem) {
    throw UserError(
        fmt::format("{}:{}:1: the estimates of '{}' {}", origin, series.lines[index], series.quantity, problem));
}

constexpr std::string_view how_it_happens =
    "Was every trial seeded alike, or a file joined to itself? Give every trial a seed of its own";

void refuse_repeats(const EstimateSeries& series, const std::string& origin) {
    const auto& values = series.values;
    if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); }))
        refuse(
            series, origin, 0,
            fmt::format("are all {} (no spread is no evidence of precision). {}; a value without randomness needs no "
                        "trials.",
                        values.front(), how_it_happens));
    if (const auto period = stats::find_period(values, repeat_alpha))
        refuse(series, origin, *period,
               fmt::format("repeat from here on those from line {} on (repeated trials are no trials). {}.",
                           series.lines.front(), how_it_happens));
    const auto repeats = stats::find_repeats(values);
    if (repeats && repeats->p < repeat_alpha)
        refuse(series, origin, repeats->later,
               fmt::format("repeat: this one is equal to that of line {}, and of {} trials {} repeat an earlier one, "
                           "where chance makes about {:.2g}. {}.",
                           series.lines[repeats->earlier], values.size(), repeats->repeats, repeats->expected,
                           how_it_happens));
}

/// Why no interval of the mean can be believed, in words; empty where nothing speaks against one. Neither test is
/// enough alone: the tail index needs thousands of values, and the variance of the variance a large one among them.
std::string heavy_tail(const std::vector<double>& values) {
    if (values.size() < fewest_for_tails) return {};
    std::vector<double> mirrored = values;
    for (double& value : mirrored) value = -value;
    for (const auto& side : {values, mirrored}) {
        const auto tail = stats::fit_tail(side);
        if (!tail) continue;
        if (stats::judge_variance(*tail, tail_alpha) == stats::VarianceHealth::infinite)
            return fmt::format("tail index {:.2g}: infinite variance, so no interval holds", *tail->index);
        const bool light = stats::judge_variance(*tail, light_alpha) == stats::VarianceHealth::finite;
        if (values.size() >= enough_for_tails && !light)
            return "the tail may be of infinite variance (its index is not shown to be above 2), so no interval holds";
    }
    const auto vov = stats::moments_of(values).variance_of_variance();
    if (vov && *vov > largest_vov)
        return fmt::format(
            "variance of the variance {:.2g} (above {}): a few values make the mean, so no interval holds", *vov,
            largest_vov);
    return {};
}

std::optional<Measurement> measurement_of(const Gate& gate, const EstimatesPlan& plan) {
    const auto moments = stats::moments_of(plan.series.values, *gate.reference);
    if (gate.kind == GateKind::bias)
        return measure_mean(moments, {.value = *gate.reference, .standard_error = gate.reference_se.value_or(0)},
                            gate.band, plan.levels, plan.independence.time);
    FF_EXPECT(gate.kind == GateKind::std);
    const auto spread = stats::spread_of(moments);
    if (!spread || plan.independence.time > 1) return std::nullopt;
    return measure_spread(*spread, *gate.reference, gate.band, plan.levels);
}

/// By the spread of the trials at hand.
std::optional<std::uint64_t> needed_trials(const Gate& gate, const EstimatesPlan& plan) {
    const auto moments = stats::moments_of(plan.series.values, *gate.reference);
    if (gate.kind == GateKind::std)
        return trials_for_ratio(gate.band, moments.excess_kurtosis().value_or(0),
                                std::numeric_limits<double>::infinity(), plan.levels, 1);
    return trials_for_mean(gate.band.high, std::sqrt(*moments.variance() * plan.independence.time), 0,
                           gate.reference_se.value_or(0), plan.levels, 1);
}

}  // namespace

Independence examine_independence(const EstimateSeries& series, const std::string& origin) {
    refuse_repeats(series, origin);
    const auto test = stats::test_serial_correlation(series.values);
    if (!test || test->p >= serial_alpha) return {};
    const double time = stats::autocorrelation_time(series.values);
    if (time <= 1) return {};
    return {.time = time,
            .note = fmt::format("trials are serially correlated (lag 1: {:.2g}, p = {:.1g}): {} are worth {:.0f}",
                                test->first, test->p, series.values.size(),
                                static_cast<double>(series.values.size()) / time)};
}

EstimatesPlan plan_estimates(const GatesSpec& spec, const Gate& gate, const EstimatesFile& file) {
    FF_EXPECT(gate.from_estimates() && gate.reference);
    EstimatesPlan plan;
    plan.gate = gate.name;
    plan.kind = gate.kind;
    plan.series = find_series(file, gate.quantity, gate.place);
    plan.independence = examine_independence(plan.series, file.origin);
    GatesSpec one_look = spec;  // nothing can be added to a file
    one_look.looks = 1;
    plan.levels = levels_of(one_look, 1);
    const auto needed = needed_trials(gate, plan);
    if (!needed)
        throw UserError(
            fmt::format("{}: no number of trials can decide (the reference is too uncertain for this band, or the band "
                        "is far below the noise). Widen the band, or find a better reference.",
                        gate.place));
    plan.needed = *needed;
    return plan;
}

GateResult judge_estimates(const GatesSpec& spec, const Gate& gate, const EstimatesFile& file) {
    const EstimatesPlan plan = plan_estimates(spec, gate, file);
    Comparison row;
    row.quantity = gate.quantity;
    row.band = gate.band;
    row.levels = plan.levels;
    row.trials = plan.series.values.size();
    row.note = plan.independence.note;
    if (const std::string reason = heavy_tail(plan.series.values); !reason.empty()) {
        row.note = reason;
    } else {
        row.measurement = measurement_of(gate, plan);
        row.verdict = judge(row.measurement, row.band);
        if (!row.measurement && plan.independence.time > 1) row.note += "; their spread cannot be judged";
    }
    return {.gate = gate.name,
            .kind = gate.kind,
            .verdict = row.verdict,
            .comparisons = {row},
            .looks = 1,
            .evaluations = 0,
            .note = row.note};
}

}  // namespace ff::studies
