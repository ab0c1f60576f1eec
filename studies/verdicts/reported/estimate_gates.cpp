#include "studies/verdicts/reported/estimate_gates.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "stats/basics/moments.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/dependence/repeats.hpp"
#include "stats/means/mean_interval.hpp"
#include "stats/variances/tails.hpp"
#include "stats/variances/variance_interval.hpp"
#include "studies/verdicts/measurement.hpp"
#include "studies/verdicts/reported/distribution_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies::gates {
namespace {

constexpr double repeat_alpha = 1e-6;
constexpr double serial_alpha = 0.05;
constexpr double fewest_effective = 30;  // independent trials that correlated ones have to be worth

[[noreturn]] void refuse_estimates(const EstimateSeries& series, const std::string& origin, std::size_t index,
                                   const std::string& problem) {
    throw UserError("{}:{}:1: the estimates of '{}' {}", origin, series.lines[index], series.quantity, problem);
}

constexpr std::string_view how_it_happens =
    "Was every trial seeded alike, or a file joined to itself? Give every trial a seed of its own";

/// @return a note on repeats; empty where there are none beyond chance
/// @throws UserError where trials were certainly repeated
std::string examine_repeats(const EstimateSeries& series, const std::string& origin) {
    const auto& values = series.values;
    if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); }))
        refuse_estimates(
            series, origin, 0,
            fmt::format("are all {} (no spread is no evidence of precision). {}; a value without randomness needs no "
                        "trials.",
                        values.front(), how_it_happens));
    if (*stats::moments_of(values, values.front()).standard_deviation() < smallest_magnitude)
        refuse_estimates(series, origin, 0,
                         fmt::format("spread by less than {:g} (its powers cannot be computed). Choose another unit.",
                                     smallest_magnitude));
    if (const auto period = stats::find_period(values, repeat_alpha))
        refuse_estimates(series, origin, *period,
                         fmt::format("repeat from here on those from line {} on (repeated trials are not trials). {}.",
                                     series.lines.front(), how_it_happens));
    const auto repeats = stats::find_repeats(values);
    if (!repeats || repeats->p >= repeat_alpha) return {};
    if (repeats->certain)
        refuse_estimates(
            series, origin, repeats->later,
            fmt::format("repeat: this one is equal to that of line {}, and of {} trials {} repeat an earlier one, "
                        "where chance makes about {:.2g}. {}.",
                        series.lines[repeats->earlier], values.size(), repeats->in_all, repeats->expected,
                        how_it_happens));
    return fmt::format(
        "{} of {} trials repeat an earlier value: estimates that take few values do, as of few rays or with few "
        "digits; "
        "otherwise seeds repeat, and the interval is too narrow",
        repeats->in_all, values.size());
}

/// The dependence of trials, and its consequence for their mean.
struct Independence {
    std::optional<stats::Autocorrelation> correlation;  ///< serial correlation, if there is one
    std::string note;                                   ///< the finding in words, if there is one
    bool enough = true;                                 ///< enough trials to judge the cost of a correlation
};

/// Rejects a series whose trials repeat; measures serial correlation in the order of trials, with a false alarm in 5 %
/// of independent series, which costs only power.
/// @throws UserError where all values are equal, where real numbers with most of their digits repeat, and where the
///         series repeats itself (by chance with a probability below 1e-6)
Independence examine_independence(const EstimateSeries& series, const std::string& origin) {
    Independence found;
    found.note = examine_repeats(series, origin);
    const auto test = stats::test_serial_correlation(series.values);
    if (!test || test->p >= serial_alpha) return found;
    const auto correlation = stats::autocorrelation_of(series.values);
    if (correlation.time <= 1) return found;
    const double effective = static_cast<double>(series.values.size()) / correlation.time;
    found.correlation = correlation;
    if (!found.note.empty()) found.note += "; ";
    found.note += fmt::format(
        "trials look serially correlated (lag 1: {:.2g}; lags 1 to {}: p = {:.1g}): {} are worth "
        "{:.0f}",
        test->first, test->lags, test->p, series.values.size(), effective);
    found.enough = effective >= fewest_effective;
    return found;
}

/// Why no interval of the mean can be believed, in words; empty where nothing speaks against one.
std::string heavy_tail(const std::vector<double>& values) {
    using enum stats::TailDoubt::Reason;
    const auto doubt = stats::doubt_tails(values);
    if (!doubt) return {};
    switch (doubt->reason) {
        case infinite_variance:
            return fmt::format("tail index {:.2g}: infinite variance, so no interval holds", doubt->value);
        case not_shown_finite:
            return "the tail may be of infinite variance (its index is not shown to be above 2), so no interval holds";
        case few_values_decide:
            return fmt::format(
                "variance of the variance {:.2g} (above {:.2g}): a few values make the mean, so no interval holds",
                doubt->value, doubt->limit);
        case outer_tails_infinite:
            break;
    }
    return fmt::format("the tails look as if their variance were infinite (index {:.2g}), so no interval holds",
                       doubt->value);
}

/// Measures a mean by confidence sequences, which hold at all looks together. The effect that would fail is not known.
Measurement measure_anytime(const Gate& gate, const std::vector<double>& values, const Levels& levels) {
    const auto interval_at = [&](double level) {
        const auto interval = gate.anytime == Anytime::normal
                                  ? stats::normal_sequence(values, gate.tightest_at, level)
                                  : stats::bounded_sequence(values, gate.bounds.low, gate.bounds.high, level);
        return interval.shifted(-*gate.reference);
    };
    return measured_at(*stats::moments_of(values, *gate.reference).bias(), levels, interval_at,
                       std::numeric_limits<double>::infinity());
}

/// @throws UserError at a value beyond the bounds that the gate states
void expect_bounded(const Gate& gate, const EstimateSeries& series, const std::string& origin) {
    for (std::size_t i = 0; i < series.values.size(); ++i) {
        if (gate.bounds.holds(series.values[i])) continue;
        refuse_estimates(
            series, origin, i,
            fmt::format("leave the bounds {:g} to {:g} of gate \"{}\" ({:g}; no interval holds where an assumption "
                        "does not). Correct the bounds, for all data again.",
                        gate.bounds.low, gate.bounds.high, gate.name, series.values[i]));
    }
}

/// The data that a gate on a file of trials has.
struct ExaminedSeries {
    EstimateSeries series;
    std::optional<EstimateSeries> other;  ///< series in the second file; empty where there is none
    Independence independence;
    Levels levels;
};

std::optional<Measurement> measurement_of(const Gate& gate, const ExaminedSeries& examined) {
    const auto& values = examined.series.values;
    if (gate.anytime != Anytime::no) {
        if (examined.independence.correlation) return std::nullopt;
        return measure_anytime(gate, values, examined.levels);
    }
    if (gate.kind == GateKind::bias)
        return measure_mean(values, {.value = *gate.reference, .standard_error = gate.reference_se.value_or(0)},
                            gate.band, examined.levels, {}, examined.independence.correlation);
    if (gate.kind == GateKind::distribution) {
        if (examined.independence.correlation) return std::nullopt;
        if (!examined.other) return measure_distribution(values, *gate.law, examined.levels);
        if (std::min(values.size(), examined.other->values.size()) < fewest_of_two) return std::nullopt;
        return measure_distributions(values, examined.other->values, examined.levels);
    }
    FF_EXPECT(gate.kind == GateKind::std);
    const auto moments = stats::moments_of(values, values.front());
    const auto spread = stats::mean_square_of(moments);
    // In units of their standard deviation, so that powers of squares do not overflow.
    std::vector<double> standardised;
    for (const double value : values) standardised.push_back((value - *moments.mean()) / *moments.standard_deviation());
    auto logarithm = logarithm_of_spread(standardised, 0);
    if (!spread || !logarithm || examined.independence.correlation) return std::nullopt;
    logarithm->value += std::log(*moments.standard_deviation());
    return measure_spread(*spread, *logarithm, *gate.reference, gate.band, examined.levels);
}

/// The note on a mean outside its band: no rule excludes values that all trials have missed.
std::string explained_by_unseen(const Gate& gate, const ExaminedSeries& examined, const Measurement& found) {
    const double end = found.value < gate.band.low ? gate.band.low : gate.band.high;
    const auto unseen = stats::unseen_value(*gate.reference + found.value, *gate.reference + end,
                                            examined.series.values.size(), examined.levels.fail_alpha / 2);
    return fmt::format("a value of {:.2g} would explain it if it occurred less often than once in {:.0f} trials",
                       unseen.value, std::ceil(unseen.one_in));
}

/// The limits of the measurement, in words.
std::string missing(const Gate& gate, const ExaminedSeries& examined, const Comparison& row) {
    if (gate.kind == GateKind::distribution) {
        if (row.measurement) return {};
        return examined.independence.correlation
                   ? "correlated values crowd as no independent ones do: their distribution is not judged"
                   : fmt::format("fewer than {} values in one of the files", fewest_of_two);
    }
    if (gate.anytime != Anytime::no) {
        if (!row.measurement) return "correlated values break the assumption of an anytime gate";
        return gate.anytime == Anytime::normal
                   ? "at any time: assumes independent normal values, and every look at the same trials with more added"
                   : "at any time: assumes values between the bounds, with one mean, and every look at the same trials "
                     "with more added";
    }
    if (!row.measurement) return examined.independence.correlation ? "their spread cannot be judged" : "no spread";
    const Measurement& m = *row.measurement;
    if (gate.kind == GateKind::bias && row.verdict == Verdict::fail) return explained_by_unseen(gate, examined, m);
    if (row.verdict != Verdict::inconclusive || (m.passing.is_finite() && m.failing.is_finite())) return {};
    const auto moments = stats::moments_of(examined.series.values, *gate.reference);
    const auto found = gate.kind == GateKind::std ? moments.excess_kurtosis() : moments.skewness();
    return fmt::format("{} {:.2g} of {} trials: too skewed, or too few, for intervals at these levels",
                       gate.kind == GateKind::std ? "excess kurtosis" : "skewness", found.value_or(0),
                       examined.series.values.size());
}

/// Standard deviation of a trial, from the trials at hand. Where they are correlated, it is that of independent trials
/// whose mean would be as uncertain.
double spread_of_trials(const ExaminedSeries& examined) {
    const auto& values = examined.series.values;
    const double time = examined.independence.correlation ? examined.independence.correlation->time : 1;
    return *stats::moments_of(values, values.front()).standard_deviation() * std::sqrt(time);
}

std::optional<std::uint64_t> trials_for_spread(const Gate& gate, const ExaminedSeries& examined) {
    const auto& values = examined.series.values;
    return trials_for_ratio(gate.band, stats::moments_of(values, values.front()).excess_kurtosis().value_or(0),
                            std::numeric_limits<double>::infinity(), examined.levels, 1);
}

/// The trials of the second file: they have to be of the same quantity, and not of a run that the first file has.
void add_other(const Gate& gate, const EstimatesFile& against, ExaminedSeries& examined) {
    examined.other = find_series(against, gate.quantity, gate.place);
    const auto second = examine_independence(*examined.other, against.origin);
    if (examined.other->values == examined.series.values)
        refuse_gate(gate, fmt::format("'{}' has the same values in both files (a file is equal to itself; that shows "
                                      "nothing). Compare runs with random numbers of their own.",
                                      gate.quantity));
    if (!examined.independence.correlation && second.correlation) examined.independence = second;
}

/// Where tails are long, squares are more skewed than trials show, and their mean too small too often: half the risk of
/// a pass keeps that rate near the promised one.
bool has_long_tails(const std::vector<double>& values) {
    const auto excess = stats::moments_of(values, values.front()).excess_kurtosis();
    return excess && *excess > 2 * *stats::excess_kurtosis_standard_error(values.size());
}

ExaminedSeries examine(const Spec& spec, const Gate& gate, const EstimatesFile& file, const EstimatesFile* against) {
    FF_EXPECT(gate.from_estimates() && (gate.reference || gate.law || against != nullptr));
    ExaminedSeries examined;
    examined.series = find_series(file, gate.quantity, gate.place);
    if (gate.kurtosis)
        refuse_gate(gate, "kurtosis is for means with standard errors (trials show theirs). Remove the key.");
    if (gate.anytime == Anytime::bounded) expect_bounded(gate, examined.series, file.origin);
    examined.independence = examine_independence(examined.series, file.origin);
    examined.levels = levels_at_one_look(spec, 1);
    if (gate.kind == GateKind::std && has_long_tails(examined.series.values)) examined.levels.pass_alpha /= 2;
    if (gate.kind == GateKind::distribution) {
        if (!gate.law) add_other(gate, *against, examined);
        return examined;
    }
    const bool decidable = gate.kind == GateKind::std
                               ? trials_for_spread(gate, examined).has_value()
                               : can_decide_mean(gate.band.high, spread_of_trials(examined),
                                                 gate.reference_se.value_or(0), examined.levels, 1);
    if (!decidable) refuse_undecidable(gate, "trials");
    return examined;
}

}  // namespace

EstimatesPlan plan_estimates(const Spec& spec, const Gate& gate, const EstimatesFile& file,
                             const EstimatesFile* against) {
    const ExaminedSeries examined = examine(spec, gate, file, against);
    EstimatesPlan plan{.gate = gate.name, .kind = gate.kind, .at_hand = examined.series.values.size()};
    if (gate.kind == GateKind::distribution) {
        plan.needed = values_for_distance(gate.band.high, examined.levels, examined.other ? 2 : 1);
        return plan;
    }
    const auto needed = gate.kind == GateKind::std ? trials_for_spread(gate, examined)
                                                   : trials_for_mean(gate.band.high, spread_of_trials(examined), 0,
                                                                     gate.reference_se.value_or(0), examined.levels, 1);
    if (!needed) refuse_undecidable(gate, "trials");
    plan.needed = *needed;
    return plan;
}

GateResult judge_estimates(const Spec& spec, const Gate& gate, const EstimatesFile& file,
                           const EstimatesFile* against) {
    const ExaminedSeries examined = examine(spec, gate, file, against);
    Comparison row;
    row.quantity = gate.quantity;
    row.band = gate.band;
    row.levels = examined.levels;
    row.trials = examined.series.values.size();
    row.note = examined.independence.note;
    const bool of_moments = gate.kind != GateKind::distribution && gate.anytime != Anytime::bounded;
    if (const std::string reason = of_moments ? heavy_tail(examined.series.values) : ""; !reason.empty()) {
        row.note = reason;
    } else if (of_moments && !examined.independence.enough) {
        row.note += ", too few to judge by";
    } else {
        row.measurement = measurement_of(gate, examined);
        row.verdict = judge(row.measurement, row.band);
        const std::string open = missing(gate, examined, row);
        row.note += row.note.empty() || open.empty() ? open : "; " + open;
    }
    return result_of(gate, row);
}

}  // namespace ff::studies::gates
