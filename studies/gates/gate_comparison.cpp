#include "core/radiosity/patch_factors.hpp"
#include "stats/dependence/repeats.hpp"
#include "stats/means/mean_interval.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/gates/gate_run.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/verdicts/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff::studies::gates {
namespace {

/// Hits of all trials together below which a t interval is too narrow in the tails.
constexpr double least_hits = 30;

/// Resamples of one bootstrap interval; there are thousands of intervals.
constexpr std::uint32_t bootstrap_replicates = 399;

bool are_equal(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

void judge_into(Comparison& row) {
    row.verdict = judge(row.measurement, row.band);
}

MeanReference mean_reference(const Gate& gate, const Effect& effect, const std::optional<StoredQuantity>& stored) {
    if (stored)
        return {.value = stored->mean,
                .standard_error = stored->standard_error,
                .freedom = static_cast<double>(std::max<std::uint64_t>(2, stored->trials) - 1),
                .skewness = stored->skewness};
    if (gate.against == Against::number)
        return {.value = *gate.reference, .standard_error = gate.reference_se.value_or(0)};
    return {.value = effect.truth.value_or(0)};
}

/// The known limits of the values whose mean a gate judges. Reciprocity is about the difference of one factor and
/// another one times the ratio of the areas: each of them may have missed something.
stats::KnownLimits limits_of(const Gate& gate, const StudyPlan& plan, const Effect& effect,
                             const CellEstimates& estimates) {
    const auto [kind, from, to] = effect.quantity;
    if (gate.kind != GateKind::reciprocity) return known_limits(plan, estimates, effect.quantity);
    const stats::Unmet there = known_limits(plan, estimates, {kind, from, to}).unmet;
    const stats::Unmet back = known_limits(plan, estimates, {kind, to, from}).unmet;
    const Eigen::VectorXd areas = face_areas(plan.scenes[plan.cells[estimates.cell].scene]);
    const double ratio = areas[to - 1] / areas[from - 1];
    return {.unmet = {.largest = there.largest + ratio * back.largest,
                      .evaluations = std::max(there.evaluations, back.evaluations)}};
}

/// Whether so few rays hit, or miss, in all trials together that their number tests nothing.
bool has_few_hits(const CellEstimates& estimates, Quantity quantity, double share) {
    const auto lattice = estimates.lattice(quantity);
    if (!lattice) return false;
    return static_cast<double>(estimates.trials()) / *lattice * std::min(share, 1 - share) < least_hits;
}

void leave_few_hits_undecided(Comparison& row) {
    row.verdict = Verdict::inconclusive;
    row.note = fmt::format("fewer than {:g} hits or misses in all trials together", least_hits);
}

/// Bias, closure and reciprocity.
void compare_means(const Gate& gate, const Plan& plan, const Effect& effect,
                   const std::optional<StoredQuantity>& stored, const CellEstimates& estimates,
                   std::span<const double> values, Comparison& row) {
    const MeanReference reference = mean_reference(gate, effect, stored);
    const auto moments = stats::moments_of(values, reference.value);
    // A row of hits adds up to 1 whatever they are, unless one is lost.
    const bool fixed_by_closure = gate.kind == GateKind::closure && are_equal(values);
    if (plan.deterministic || fixed_by_closure) {
        row.measurement = measure_exactly(*moments.bias(), row.band);
        return judge_into(row);
    }
    row.measurement =
        measure_mean(values, reference, row.band, plan.levels, limits_of(gate, plan.study, effect, estimates));
    judge_into(row);
    if (!row.measurement) row.note = "every trial gave the same value";
    if (stored && stored->standard_error == 0) {
        row.verdict = Verdict::inconclusive;
        row.note = "every trial of the baseline gave the same value";
    }
    if (gate.kind == GateKind::bias && has_few_hits(estimates, effect.quantity, reference.value))
        leave_few_hits_undecided(row);
}

/// The number of evaluations is the same, so efficiencies are as one over the variances.
/// @param ratio  logarithm of the ratio of the standard deviations
Measurement measure_efficiency(const stats::MeanSquare& own, const stats::MeanSquare& other, stats::Measured ratio,
                               const Band& band, const Levels& levels) {
    Measurement measurement = measure_spread(other, own, {std::sqrt(band.low), std::sqrt(band.high)}, levels);
    ratio.value *= -1;
    for (stats::Measured::Part& part : ratio.parts) part.weight *= -1;
    allow_for_skewness(measurement, ratio, true, {std::sqrt(band.low), std::sqrt(band.high)}, levels);
    const auto square = [](double x) { return x * x; };
    for (stats::Interval* interval : {&measurement.passing, &measurement.failing}) {
        interval->low = square(interval->low);
        interval->high = square(interval->high);
    }
    measurement.value = square(measurement.value);
    measurement.minimum_detectable = square(measurement.minimum_detectable);
    return measurement;
}

/// Half the logarithm of a mean square of the baseline, as the part of a ratio that it is below.
stats::Measured logarithm_of(const StoredSpread& spread) {
    const double value = std::log(spread.mean_square) / 2;
    if (spread.evidence) return {value, {{.mean = *spread.evidence, .weight = -0.5, .logarithm = true}}};
    return stats::with_error(value, 1 / std::sqrt(2 * spread.freedom), std::max<std::size_t>(2, spread.n));
}

void compare_spreads(const Gate& gate, const Plan& plan, const Effect& effect,
                     const std::optional<StoredQuantity>& stored, const CellEstimates& estimates,
                     std::span<const double> values, Comparison& row) {
    const bool about_truth = gate.kind == GateKind::rmse;
    const auto moments = stats::moments_of(values, values.front());
    const double centre = about_truth ? effect.truth.value_or(0) : *moments.mean();
    const auto spread = about_truth ? stats::mean_square_about(values, centre) : stats::mean_square_of(moments);
    const auto logarithm = logarithm_of_spread(
        values, centre,
        unmet_squares({limits_of(gate, plan.study, effect, estimates).unmet}, estimates.samples_of_pair));
    if (!spread || !logarithm) {
        row.note = "fewer than four trials, or all alike";
        return;
    }
    stats::Measured ratio = *logarithm;  // half the logarithm of the mean square, less that of the reference
    Measurement measurement;
    if (!stored) {
        measurement = measure_spread(*spread, *logarithm, gate.reference ? *gate.reference : *effect.sigma, row.band,
                                     plan.levels);
    } else {
        const auto& reference = about_truth ? stored->mean_square_error : stored->variance;
        if (!reference) {
            row.note = "the baseline has no spread";
            return;
        }
        // What our trials may have missed those of the baseline may have missed too.
        const auto before = logarithm_of(*reference);
        ratio.value -= before.value;
        ratio.parts.push_back(before.parts.front());
        if (logarithm->parts.front().mean.unmet.largest > 0) {
            ratio.parts.push_back(logarithm->parts.front());
            ratio.parts.back().weight *= -1;
        }
        measurement = gate.kind == GateKind::efficiency
                          ? measure_efficiency(*spread, *reference, ratio, row.band, plan.levels)
                          : measure_spread(*spread, *reference, row.band, plan.levels);
        if (gate.kind != GateKind::efficiency) allow_for_skewness(measurement, ratio, true, row.band, plan.levels);
    }
    row.measurement = measurement;
    judge_into(row);
    const double share = effect.truth.value_or(*moments.mean());
    if (has_few_hits(estimates, effect.quantity, share)) leave_few_hits_undecided(row);
}

void compare_losses(const Gate& gate, const Plan& plan, const CellEstimates& estimates, std::uint64_t rays,
                    Comparison& row) {
    row.measurement = measure_proportion({.hits = estimates.lost_rays, .trials = rays}, row.band, plan.levels);
    if (row.band.high > 0) return judge_into(row);
    // No lost ray is tolerated, so a single one decides. That there are none is known only as far as the number of rays
    // allows.
    row.measurement->minimum_detectable = -std::expm1(std::log1p(-plan.levels.power) / static_cast<double>(rays));
    const bool enough = static_cast<double>(rays) >= rays_for_loss(gate.detects, plan.levels);
    row.verdict = estimates.lost_rays > 0 ? Verdict::fail : enough ? Verdict::pass : Verdict::inconclusive;
    if (row.verdict == Verdict::inconclusive) row.note = "too few rays";
}

/// The gate's interval from consecutive trials (or one, for hits); empty where they are all alike.
std::optional<stats::Interval> interval_of(const Gate& gate, std::span<const double> values, double truth,
                                           std::uint64_t rays, StreamKey key) {
    const stats::Proportion counts{
        .hits = static_cast<std::uint64_t>(std::llround(values.front() * static_cast<double>(rays))), .trials = rays};
    const double level = gate.interval_level;
    switch (gate.interval) {
        case IntervalMethod::student_t:
            return stats::mean_interval_t(stats::moments_of(values, truth), level);
        case IntervalMethod::normal:
            return stats::mean_interval_normal(stats::moments_of(values, truth), level);
        case IntervalMethod::percentile_bootstrap:
            return stats::mean_interval_bootstrap(values, level, {.key = key, .replicates = bootstrap_replicates});
        case IntervalMethod::wilson:
            return stats::wilson_interval(counts, level);
        case IntervalMethod::clopper_pearson:
            return stats::clopper_pearson_interval(counts, level);
        case IntervalMethod::wald:
            break;
    }
    return stats::wald_interval(counts, level);
}

void compare_coverage(const Gate& gate, const Plan& plan, const Effect& effect, std::span<const double> values,
                      std::uint64_t rays, Comparison& row) {
    stats::Proportion covered;
    for (std::size_t first = 0; first + gate.replicates <= values.size(); first += gate.replicates) {
        const StreamKey key =
            derive_key(plan.study.spec.seed, fmt::format("coverage|{}|{}|{}", row.from_face, row.to_face, first));
        const auto interval = interval_of(gate, values.subspan(first, gate.replicates), *effect.truth, rays, key);
        ++covered.trials;
        // An empty interval does not count as covering: trials that are all equal claim to be exact.
        if (interval && interval->contains(*effect.truth)) ++covered.hits;
    }
    if (covered.trials == 0) {
        row.note = "fewer trials than one interval needs";
        return;
    }
    row.measurement = measure_proportion(covered, row.band, plan.levels);
    judge_into(row);
}

void compare_slope(const Gate& gate, const Plan& plan, const Effect& effect, std::span<const CellEstimates> estimates,
                   Comparison& row) {
    std::vector<stats::Rung> ladder;
    std::vector<stats::Unmet> unmet;
    for (const std::size_t cell : effect.cells) {
        const CellEstimates& here = estimates[cell];
        stats::Rung rung{static_cast<double>(here.samples_of_pair), {}};
        for (const double value : here.values(effect.quantity)) rung.errors.push_back(value - *effect.truth);
        ladder.push_back(std::move(rung));
        unmet.push_back(unmet_squares({limits_of(gate, plan.study, effect, here).unmet}, here.samples_of_pair));
    }
    row.measurement = measure_slope(ladder, row.band, plan.levels);
    const auto rate = stats::measured_rmse_rate(ladder, unmet);
    if (!row.measurement || !rate) {
        row.measurement.reset();
        row.note = "no error at some size";
    } else {
        allow_for_skewness(*row.measurement, *rate, false, row.band, plan.levels);
    }
    judge_into(row);
    const auto is_sparse = [&](std::size_t cell) {
        return has_few_hits(estimates[cell], effect.quantity, *effect.truth);
    };
    if (std::any_of(effect.cells.begin(), effect.cells.end(), is_sparse)) leave_few_hits_undecided(row);
}

/// Trials that repeat each other are not replicates, whatever their mean.
void expect_replicates(const Plan& plan, std::span<const double> values, Comparison& row) {
    if (plan.deterministic || are_equal(values)) return;
    const auto period = stats::find_period(values, plan.levels.fail_alpha);
    if (!period) return;
    row.verdict = Verdict::fail;
    row.note = fmt::format("trials repeat after {}: they are not replicates", *period);
}

/// A single quantity may have the same value in all trials by chance, where hits are few, but not all quantities of a
/// gate.
void expect_some_spread(const Plan& plan, std::span<const CellEstimates> estimates, std::vector<Comparison>& rows) {
    constexpr std::size_t enough = 8;
    if (plan.deterministic) return;
    for (const CellEstimates& cell : estimates) {
        if (cell.trials() < enough) return;
        for (const auto& values : cell.factors) {
            if (!values.empty() && !are_equal(values)) return;
        }
    }
    for (Comparison& row : rows) {
        row.verdict = Verdict::fail;
        row.note = "every trial gave the same values: they are not replicates";
    }
}

}  // namespace

std::vector<Comparison> compare(const Gate& gate, const Plan& plan, std::span<const CellEstimates> estimates) {
    std::vector<Comparison> rows;
    for (std::size_t i = 0; i < plan.effects.size(); ++i) {
        const Effect& effect = plan.effects[i];
        const Cell& cell = plan.study.cells[effect.cells.front()];
        const CellEstimates& first = estimates[effect.cells.front()];
        Comparison row = labelled(gate, effect, plan.study);
        row.levels = plan.levels;
        row.trials = first.trials();
        if (gate.kind == GateKind::lost_rays) {
            compare_losses(gate, plan, first, row.trials * evaluations_per_trial(plan.study, cell), row);
            rows.push_back(std::move(row));
            continue;
        }
        const auto values = series(gate.kind, effect, first, plan.study.scenes[cell.scene]);
        switch (gate.kind) {
            case GateKind::bias:
            case GateKind::closure:
            case GateKind::reciprocity:
                compare_means(gate, plan, effect, plan.stored[i], first, values, row);
                break;
            case GateKind::std:
            case GateKind::rmse:
            case GateKind::efficiency:
                compare_spreads(gate, plan, effect, plan.stored[i], first, values, row);
                break;
            case GateKind::coverage:
                compare_coverage(gate, plan, effect, values, first.samples_of_pair, row);
                break;
            case GateKind::slope:
                compare_slope(gate, plan, effect, estimates, row);
                break;
            case GateKind::lost_rays:
            case GateKind::equal:
            case GateKind::std_error:
            case GateKind::distribution:
                break;
        }
        expect_replicates(plan, values, row);
        rows.push_back(std::move(row));
    }
    expect_some_spread(plan, estimates, rows);
    return rows;
}

}  // namespace ff::studies::gates
