#include "studies/gates/gate_plan.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/run/run.hpp"
#include "studies/verdicts/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies::gates {
namespace {

/// Confidence that a standard deviation is no larger than its upper limit from the pilot.
constexpr double pilot_confidence = 0.9;

/// Trials are kept in memory, a value for each pair of faces: 2 GB.
constexpr double most_values = 2.5e8;

const Gate& gate_of(const Spec& spec, const Plan& plan) {
    return spec.gates[plan.gate];
}

/// Gives the cells random numbers of their own.
void reseed(const Spec& spec, std::string_view use, StudyPlan& study) {
    for (Cell& cell : study.cells) cell.key = derive_key(spec.seed, fmt::format("{}|{}", cell.canonical, use));
}

void attach_baseline(const Gate& gate, const Baseline* baseline, Plan& plan) {
    plan.stored.resize(plan.effects.size());
    if (gate.against != Against::baseline || plan.purpose == GatePurpose::save_baseline) return;
    if (baseline == nullptr)
        refuse_gate(gate, fmt::format("gate '{}' compares with a baseline (none is given). Add --baseline FILE, or "
                                      "make one with --save-baseline FILE.",
                                      gate.name));
    const StoredGate* stored = baseline->find(gate.name);
    if (stored == nullptr)
        throw UserError(
            "{}: has no gate '{}' (nothing to compare with). Save it again with "
            "--save-baseline.",
            baseline->origin, gate.name);
    plan.stored_seconds_per_trial = stored->seconds_per_trial;
    if (stored->quantities.size() != plan.effects.size())
        throw UserError(
            "{}: gate '{}' had {} quantities, here it has {} (a changed study cannot be "
            "compared). Save it again with --save-baseline.",
            baseline->origin, gate.name, stored->quantities.size(), plan.effects.size());
    for (std::size_t i = 0; i < plan.effects.size(); ++i) {
        const StoredQuantity& there = stored->quantities[i];
        const std::string here = identity(plan.study, plan.effects[i].cells.front());
        if (there.cell != here || there.quantity != plan.effects[i].quantity)
            throw UserError(
                "{}: gate '{}' was '{}', here it is '{}' (a changed study cannot be compared). "
                "Save it again with --save-baseline.",
                baseline->origin, gate.name, there.cell, here);
        plan.stored[i] = there;
    }
}

/// The planning data of one effect.
struct Noise {
    double sigma = 0;
    double skewness = 0;
    double excess_kurtosis = 0;
};

Noise noise_of(std::span<const double> values) {
    Noise noise;
    if (values.empty()) return noise;
    const auto moments = stats::moments_of(values, values.front());
    const auto spread = stats::mean_square_of(moments);
    if (!spread) return noise;
    noise.sigma = std::sqrt(stats::mean_square_interval(*spread, 2 * pilot_confidence - 1).high);
    const double chance = 2 * *stats::skewness_standard_error(values.size());
    noise.skewness = std::max(0.0, std::abs(*moments.skewness()) - chance);
    noise.excess_kurtosis = *moments.excess_kurtosis();
    return noise;
}

/// Noise of counted hits, whose skewness and kurtosis are nearly those of a binomial distribution.
Noise noise_of_hits(const Effect& effect, const Cell& cell) {
    const double rays = static_cast<double>(cell.samples_per_patch) * cell.subdivision.per_part();
    const double p = effect.truth.value_or(0.5);
    const double variance = rays * p * (1 - p);
    if (!(variance > 0)) return {*effect.sigma, 0, 0};
    return {*effect.sigma, std::abs(1 - 2 * p) / std::sqrt(variance), std::max(0.0, (1 - 6 * p * (1 - p)) / variance)};
}

/// @param estimates  of the pilot, by cell; empty where there was none
std::vector<Noise> noise_of_all(const Gate& gate, const Plan& plan, const std::vector<CellEstimates>& estimates) {
    std::vector<Noise> all;
    double kurtosis = 0;
    for (const Effect& effect : plan.effects) {
        const std::size_t index = effect.cells.front();
        const Cell& cell = plan.study.cells[index];
        Noise noise;
        if (!estimates.empty()) {
            noise = noise_of(series(gate.kind, effect, estimates[index], plan.study.scenes[cell.scene]));
        } else if (effect.sigma) {
            noise = noise_of_hits(effect, cell);
        }
        kurtosis += noise.excess_kurtosis;
        all.push_back(noise);
    }
    // A pilot says little about a single kurtosis; its quantities together say more.
    for (Noise& noise : all) noise.excess_kurtosis = kurtosis / static_cast<double>(all.size());
    return all;
}

bool needs_pilot(const Gate& gate, const Plan& plan) {
    if (plan.deterministic || gate.trials || gate.kind == GateKind::lost_rays || gate.kind == GateKind::coverage)
        return false;
    if (gate.kind == GateKind::slope) return true;
    return !std::all_of(plan.effects.begin(), plan.effects.end(),
                        [](const Effect& effect) { return effect.sigma.has_value(); });
}

std::optional<std::uint64_t> trials_against_loss(const Gate& gate, const Plan& plan, const Cell& cell) {
    const auto rays = static_cast<double>(evaluations_per_trial(plan.study, cell));
    const double needed = gate.band.high > 0 ? 4 * std::log(plan.levels.pass_alpha) / std::log1p(-gate.band.high)
                                             : rays_for_loss(gate.detects, plan.levels);
    if (needed / rays > 1e15) return std::nullopt;
    return static_cast<std::uint64_t>(std::max(1.0, std::ceil(needed / rays)));
}

/// Trials of one look that this effect needs; empty where no number is enough.
std::optional<std::uint64_t> needed(const Gate& gate, const Plan& plan, std::size_t index, const Noise& noise) {
    const Effect& effect = plan.effects[index];
    const std::size_t comparisons = plan.effects.size();
    const auto& stored = plan.stored[index];
    // A baseline is saved with twice the trials that an exact reference would need, and so is each later run.
    const double shared = plan.purpose == GatePurpose::save_baseline && gate.against == Against::baseline ? 2 : 1;
    switch (gate.kind) {
        case GateKind::bias:
        case GateKind::closure:
        case GateKind::reciprocity: {
            const double reference_se = stored ? stored->standard_error : gate.reference_se.value_or(0);
            return trials_for_mean(gate.band.high, noise.sigma * std::sqrt(shared), noise.skewness, reference_se,
                                   plan.levels, comparisons);
        }
        case GateKind::std:
        case GateKind::rmse:
        case GateKind::efficiency: {
            Band band = gate.band;
            double freedom = std::numeric_limits<double>::infinity();
            const auto& spread = gate.kind == GateKind::rmse ? stored.value_or(StoredQuantity{}).mean_square_error
                                                             : stored.value_or(StoredQuantity{}).variance;
            if (spread) freedom = spread->freedom;
            // Efficiency is one over the variance: the square of the ratio that is planned for.
            if (gate.kind == GateKind::efficiency)
                band = {std::isfinite(band.high) ? 1 / std::sqrt(band.high) : 0, 1 / std::sqrt(band.low)};
            const double narrower = 1 / std::sqrt(shared);
            return trials_for_ratio({std::pow(band.low, narrower), std::pow(band.high, narrower)},
                                    noise.excess_kurtosis, freedom, plan.levels, comparisons);
        }
        case GateKind::lost_rays:
            return trials_against_loss(gate, plan, plan.study.cells[effect.cells.front()]);
        case GateKind::coverage: {
            const auto intervals = trials_for_proportion(gate.band, gate.interval_level, plan.levels, comparisons);
            return intervals ? std::optional(*intervals * gate.replicates) : std::nullopt;
        }
        case GateKind::slope:
        case GateKind::equal:
        case GateKind::std_error:
        case GateKind::distribution:
            break;
    }
    std::vector<double> sizes;
    for (const std::size_t cell : effect.cells)
        sizes.push_back(static_cast<double>(plan.study.cells[cell].samples_per_patch) *
                        plan.study.cells[cell].subdivision.per_part());
    return trials_for_slope(gate.band, sizes, 1 + std::max(0.0, noise.excess_kurtosis) / 2, plan.levels, comparisons);
}

void expect_to_fit(const Spec& spec, const Plan& plan) {
    double values = 0;
    for (std::size_t cell = 0; cell < plan.trials.size(); ++cell) {
        const auto faces = static_cast<double>(plan.study.scenes.faces(plan.study.cells[cell].scene).size());
        values += static_cast<double>(plan.trials[cell] * spec.looks) * faces * faces;
    }
    if (values <= most_values) return;
    refuse_gate(gate_of(spec, plan), fmt::format("the trials would fill {:.0f} GB of memory (at most {:.0f}). Take "
                                                 "fewer trials with more samples each.",
                                                 values * 8e-9, most_values * 8e-9));
}

}  // namespace

Trials::Trials(const StudyPlan& plan) : plan_(&plan), cells_(plan.cells.size()) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        const std::size_t faces = plan.scenes.faces(plan.cells[cell].scene).size();
        cells_[cell].values.resize(faces * faces);
    }
}

bool Trials::extend(std::span<const std::uint64_t> trials, const GateRunOptions& options) {
    FF_EXPECT(trials.size() == cells_.size());
    std::vector<WorkUnit> units;
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        DirectEstimates& direct = cells_[cell];
        const std::uint64_t first = direct.trials();
        if (first >= trials[cell]) continue;
        add_units(*plan_, cell, first, trials[cell], units);
        for (std::uint64_t trial = first; trial < trials[cell]; ++trial) direct.trial_numbers.push_back(trial);
        const std::size_t faces = plan_->scenes.faces(plan_->cells[cell].scene).size();
        for (std::size_t pair = 0; pair < direct.values.size(); ++pair) {
            if (pair / faces != pair % faces) direct.values[pair].resize(trials[cell]);
        }
    }
    StudyPlan part = *plan_;
    part.units = std::move(units);
    RunOptions run;
    run.threads = options.threads;
    run.stop = run.drop = options.stop;  // nothing is kept
    std::size_t done = 0;
    carry_out_units(part, std::vector<bool>(part.units.size(), false), run, [&](const UnitRecord& record) {
        keep(record, part.units[record.unit].cell);
        ++done;
    });
    return done == part.units.size();
}

void Trials::keep(const UnitRecord& record, std::size_t cell) {
    DirectEstimates& direct = cells_[cell];
    const auto faces = static_cast<int>(plan_->scenes.faces(plan_->cells[cell].scene).size());
    for (const Observation& seen : record.observations) {
        const double value = std::visit([](auto number) { return static_cast<double>(number); }, seen.value);
        if (seen.observable == observable::lost) direct.lost_rays += static_cast<std::uint64_t>(value);
        if (seen.observable != observable::hits && seen.observable != observable::estimate) continue;
        const auto pair = static_cast<std::size_t>((seen.from_face - 1) * faces + seen.to_face - 1);
        direct.values[pair][seen.trial] = value;
    }
}

CellEstimates Trials::estimates(std::size_t cell) const {
    const Method& method = plan_->spec.methods[plan_->cells[cell].method];
    return complete(*plan_, cell, method.completion, cells_[cell]);
}

std::uint64_t Trials::evaluations() const {
    std::uint64_t sum = 0;
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        sum += cells_[cell].trials() * evaluations_per_trial(*plan_, plan_->cells[cell]);
    return sum;
}

Plan prepare_gate(const Spec& spec, std::size_t index, GatePurpose purpose, const Baseline* baseline) {
    const Gate& gate = spec.gates[index];
    FF_EXPECT(!gate.from_estimates());
    StudySpec study;
    study.name = spec.name;
    study.scenes = experiment_of(gate).scenes;
    study.trials = 2;
    study.seed = spec.seed;
    study.methods = {experiment_of(gate).method};
    Plan plan;
    plan.gate = index;
    plan.purpose = purpose;
    try {
        plan.study = plan_study(std::move(study));
    } catch (const UserError& error) {
        refuse_gate(gate, error.what());
    }
    if (purpose == GatePurpose::save_baseline) reseed(spec, "baseline", plan.study);
    plan.deterministic = plan.study.cells.front().deterministic;
    plan.effects = effects_of(gate, plan.study);
    plan.levels = levels_of(spec, plan.effects.size());
    attach_baseline(gate, baseline, plan);
    return plan;
}

std::optional<std::uint64_t> plan_trials(const Spec& spec, Plan& plan, const GateRunOptions& options) {
    const Gate& gate = gate_of(spec, plan);
    const std::size_t cells = plan.study.cells.size();
    plan.trials.assign(cells, plan.deterministic ? 1 : gate.trials.value_or(0));
    if (plan.deterministic || gate.trials) {
        expect_to_fit(spec, plan);
        return 0;
    }

    StudyPlan study = plan.study;
    reseed(spec, "pilot", study);
    Trials pilot(study);
    const bool piloted = needs_pilot(gate, plan);
    if (piloted && !pilot.extend(std::vector<std::uint64_t>(cells, pilot_trials), options)) return std::nullopt;
    std::vector<CellEstimates> estimates;
    for (std::size_t cell = 0; piloted && cell < cells; ++cell) estimates.push_back(pilot.estimates(cell));

    double wanted = 0;
    const std::vector<Noise> noise = noise_of_all(gate, plan, estimates);
    for (std::size_t i = 0; i < plan.effects.size(); ++i) {
        const Effect& effect = plan.effects[i];
        const auto trials = needed(gate, plan, i, noise[i]);
        if (!trials)
            refuse_gate(gate,
                        "no number of trials can decide (the reference is too uncertain for this band, or the band is "
                        "far below the noise). Widen the band, or save the baseline with a narrower one.");
        wanted = std::max(wanted, static_cast<double>(*trials));
        for (const std::size_t c : effect.cells)
            plan.trials[c] = std::min(spec.max_trials, std::max(plan.trials[c], *trials));
    }
    if (wanted > static_cast<double>(spec.max_trials)) plan.wanted_trials = wanted;
    expect_to_fit(spec, plan);
    return pilot.evaluations();
}

double expected_seconds(const Plan& plan) {
    double seconds = 0;
    for (std::size_t cell = 0; cell < plan.trials.size(); ++cell)
        seconds +=
            static_cast<double>(plan.trials[cell]) * expected_seconds_per_trial(plan.study, plan.study.cells[cell]);
    return seconds;
}

}  // namespace ff::studies::gates
