#include "studies/gates/gate_experiment.hpp"

#include "core/exact/known_factors.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/visibility/pair_class.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/readers/toml_reader.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace ff::studies::gates {
namespace {

/// Keys of a gate beside those of a method.
constexpr std::array<std::string_view, 12> gate_keys{"kind",         "scene",    "pairs",     "band",
                                                     "expected",     "quantity", "interval",  "level",
                                                     "reference_se", "detects",  "reference", "replicates"};

void read_coverage(const TomlReader& reader, Gate& gate) {
    gate.interval = reader.choice("interval", gate.interval);
    gate.interval_level = reader.optional_number("level").value_or(gate.interval_level);
    if (!stats::is_level(gate.interval_level))
        reader.fail(
            "level",
            "(intervals are right more often than not, but not always: above 0.5, at most 1 - 1e-9). Try 0.95.");
    if (is_binomial(gate.interval) && reader.has("replicates"))
        reader.fail("replicates", "(this interval is made from the hits of one trial). Remove the key.");
    gate.replicates = is_binomial(gate.interval) ? 1 : reader.optional_count("replicates").value_or(gate.replicates);
    if (!is_binomial(gate.interval) && (gate.replicates < 2 || gate.replicates > 100'000))
        reader.fail("replicates", "(an interval is made from 2 to 100000 trials). Try 10.");
}

std::string pair_text(const Scene& scene, Quantity pair) {
    return fmt::format("{}-{}", scene.faces[static_cast<std::size_t>(pair.from - 1)],
                       scene.faces[static_cast<std::size_t>(pair.to - 1)]);
}

/// Whether the gate's `pairs` name this one; 6-1 is 1-6 where only one of the two is free.
bool is_selected(const Gate& gate, const Scene& scene, Quantity pair, bool both_ways) {
    const auto pair_class = name(ff::pair_class(scene, pair.from - 1, pair.to - 1));
    const std::string there = pair_text(scene, pair);
    const std::string back = pair_text(scene, {pair.kind, pair.to, pair.from});
    return std::any_of(gate.pairs.begin(), gate.pairs.end(), [&](const std::string& wanted) {
        return wanted == "all" || wanted == pair_class || wanted == there || (both_ways && wanted == back);
    });
}

std::vector<Quantity> selected_pairs(const Gate& gate, const Scene& scene) {
    const bool both_ways =
        gate.kind == GateKind::reciprocity || experiment_of(gate).method.completion == Completion::reciprocal;
    std::vector<Quantity> pairs;
    for (const Quantity pair :
         distinct_pairs(scene.faces.size(), both_ways ? Completion::reciprocal : Completion::direct)) {
        if (is_selected(gate, scene, pair, both_ways)) pairs.push_back(pair);
    }
    if (!pairs.empty()) return pairs;
    std::vector<std::string> texts{"all", "parallel", "adjacent", "other"};
    for (const Quantity pair : distinct_pairs(scene.faces.size(), Completion::direct))
        texts.push_back(pair_text(scene, pair));
    const std::vector<std::string_view> known(texts.begin(), texts.end());
    throw UserError(
        "{}: pairs = '{}' (scene '{}' has none of these). {}Write \"all\", \"parallel\", \"adjacent\", or "
        "faces as \"{}\".",
        gate.pairs_place, fmt::join(gate.pairs, "', '"), scene.name, did_you_mean(gate.pairs.front(), known), texts[4]);
}

std::vector<Quantity> quantities_of(const Gate& gate, const Scene& scene) {
    if (gate.kind == GateKind::lost_rays) return {Quantity{}};
    if (gate.kind != GateKind::closure) return selected_pairs(gate, scene);
    std::vector<Quantity> sums;
    for (int face = 1; face <= static_cast<int>(scene.faces.size()); ++face)
        sums.push_back({QuantityKind::row_sum, face, 0});
    return sums;
}

/// Kinds that judge the spread need one.
bool needs_spread(GateKind kind) {
    return kind == GateKind::std || kind == GateKind::rmse || kind == GateKind::coverage || kind == GateKind::slope ||
           kind == GateKind::efficiency;
}

void expect_possible(const Gate& gate, const StudyPlan& plan) {
    const Method& method = experiment_of(gate).method;
    const bool deterministic = plan.cells.front().deterministic;
    const bool shoots = estimator_info(method).observes == Observes::hits;
    if (deterministic && needs_spread(gate.kind))
        refuse_gate(gate, fmt::format("a gate of kind \"{}\" needs trials that differ (this method is deterministic). "
                                      "Take a randomised sampler, or kind = \"bias\".",
                                      name(gate.kind)));
    if (gate.kind == GateKind::reciprocity && method.completion == Completion::reciprocal)
        refuse_gate(gate,
                    R"(reciprocity (completion = "reciprocal" makes it hold by itself). Take completion = "direct".)");
    if (gate.kind == GateKind::lost_rays && !shoots)
        refuse_gate(gate, "lost_rays (this estimator shoots none). Take estimator = \"ray_shooting\".");
    if (gate.kind == GateKind::lost_rays && !plan.scenes.front().closed)
        refuse_gate(gate, "lost_rays (in an open scene rays may leave). Take a closed scene.");
    const bool independent = shoots && samplers::find(method.sampler).info.independent();
    if (gate.kind == GateKind::lost_rays && gate.band.high > 0 && !independent)
        refuse_gate(gate, "band above 0 (the exact interval wants independent rays). Take band = 0.");
    if (gate.kind == GateKind::coverage && is_binomial(gate.interval) && !independent)
        refuse_gate(gate, fmt::format("interval = \"{}\" (it is for hits of independent rays). Take a sampler with "
                                      "independent points and estimator = \"ray_shooting\".",
                                      name(gate.interval)));
    if (gate.kind == GateKind::bias && gate.against == Against::number && gate.pairs.size() == 1 &&
        gate.pairs.front() == "all")
        refuse_gate(gate, "reference (one number for all pairs). Name the pair, as pairs = \"1-6\".");
    if (gate.kind == GateKind::slope && method.sizes.size() < 2)
        refuse_gate(gate, "a slope needs a ladder (one size gives none). Write samples_per_patch = [64, 256, 1024].");
}

void expect_finite(const Gate& gate, const Scene& scene, Quantity quantity) {
    if (gate.kind == GateKind::lost_rays) return;
    Quantity back = quantity;  // quantity that reciprocity compares with
    if (gate.kind == GateKind::reciprocity) std::swap(back.from, back.to);
    if (known_variance(experiment_of(gate).method, scene, quantity) != VarianceStatus::infinite &&
        known_variance(experiment_of(gate).method, scene, back) != VarianceStatus::infinite)
        return;
    const std::string what = quantity.kind == QuantityKind::form_factor
                                 ? "pair " + pair_text(scene, quantity)
                                 : fmt::format("the sum of face {}", quantity.from);
    refuse_gate(gate, fmt::format("{} (its variance is infinite, and no number of trials can decide). Take pairs = "
                                  "\"parallel\", map = \"graded\" or another estimator.",
                                  what));
}

/// Exact moments of one trial of ray shooting with independent rays.
std::optional<SrDistribution> known_distribution(const Gate& gate, const Scene& scene, const Cell& cell) {
    const Method& method = experiment_of(gate).method;
    const bool known = estimator_info(method).observes == Observes::hits && scene.empty_box &&
                       method.tracer != TracerChoice::leaky && samplers::find(method.sampler).info.independent();
    if (!known) return std::nullopt;
    return sr_distribution(scene, cell.subdivision, static_cast<double>(cell.samples_per_patch), method.completion);
}

void expect_references(const Gate& gate, const Effect& effect) {
    const bool spread = gate.kind == GateKind::std || gate.kind == GateKind::rmse;
    if (spread && gate.against == Against::exact && !effect.sigma)
        refuse_gate(gate,
                    fmt::format("reference missing (the exact standard deviation is known for independent rays in "
                                "an empty box only). Add reference = a number, or \"baseline\"."));
    const bool truth = (gate.kind == GateKind::bias && gate.against == Against::exact) ||
                       gate.kind == GateKind::closure || gate.kind == GateKind::rmse ||
                       gate.kind == GateKind::coverage || gate.kind == GateKind::slope;
    if (gate.kind == GateKind::closure && !effect.truth)
        refuse_gate(
            gate,
            "closure (the scene is open: rows need not sum to 1, and what they sum to is not known). Take a closed "
            "scene.");
    if (truth && !effect.truth)
        refuse_gate(gate, "no exact value is known for this scene. Add reference = a number, or \"baseline\".");
}

}  // namespace

const GateExperiment& experiment_of(const Gate& gate) {
    FF_EXPECT(gate.experiment != nullptr);
    return *gate.experiment;
}

void read_experiment(const TomlReader& reader, Gate& gate) {
    GateExperiment experiment{.scenes = {}, .method = read_method(reader, gate_keys)};
    experiment.scenes = read_scenes(reader);
    if (gate.kind == GateKind::coverage) read_coverage(reader, gate);
    if (gate.kind == GateKind::lost_rays) {
        gate.detects = reader.optional_number("detects").value_or(gate.detects);
        if (gate.detects <= 0 || gate.detects >= 1) reader.fail("detects", "(a share of rays). Try 1e-6.");
    }
    gate.pairs = reader.has("pairs") ? reader.texts("pairs") : std::vector<std::string>{"all"};
    gate.pairs_place = reader.place("pairs");
    if (!experiment.method.sizes.empty()) gate.trials = experiment.method.sizes.front().trials;
    for (const Size& size : experiment.method.sizes) {
        if (size.trials != gate.trials)
            reader.fail("sizes", "(a gate has one number of trials for all its sizes). Give each the same, or none.");
    }
    gate.experiment = std::make_shared<const GateExperiment>(std::move(experiment));
}

std::vector<Effect> effects_of(const Gate& gate, const StudyPlan& plan) {
    expect_possible(gate, plan);
    std::vector<Effect> effects;
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const Cell& cell = plan.cells[index];
        const Scene& scene = plan.scenes[cell.scene];
        const bool first_of_ladder = index == 0 || plan.cells[index - 1].scene != cell.scene;
        if (gate.kind == GateKind::slope && !first_of_ladder) continue;
        const KnownFactors known = known_factors(scene);
        const auto distribution = known_distribution(gate, scene, cell);
        for (const Quantity quantity : quantities_of(gate, scene)) {
            Effect effect;
            effect.cells = {index};
            for (std::size_t other = index + 1; gate.kind == GateKind::slope && other < plan.cells.size(); ++other) {
                if (plan.cells[other].scene == cell.scene) effect.cells.push_back(other);
            }
            effect.quantity = quantity;
            const bool pair = gate.kind != GateKind::lost_rays && quantity.kind == QuantityKind::form_factor;
            expect_finite(gate, scene, quantity);
            const bool none = gate.kind == GateKind::reciprocity || gate.kind == GateKind::lost_rays;
            effect.truth = none ? 0 : reference_of(scene, known, quantity);
            if (distribution && pair && gate.kind != GateKind::reciprocity)
                effect.sigma = distribution->pair_sigma(quantity.from - 1, quantity.to - 1);
            if (distribution && quantity.kind == QuantityKind::row_sum)
                effect.sigma = distribution->sum_sigma(quantity.from - 1);
            expect_references(gate, effect);
            effects.push_back(std::move(effect));
        }
    }
    return effects;
}

std::vector<double> series(GateKind kind, const Effect& effect, const CellEstimates& estimates, const Scene& scene) {
    if (kind != GateKind::reciprocity) return estimates.values(effect.quantity);
    const auto [pair_kind, from, to] = effect.quantity;
    std::vector<double> values = estimates.values(effect.quantity);
    const auto& back = estimates.values({pair_kind, to, from});
    const double ratio = face_area(scene, to - 1) / face_area(scene, from - 1);
    for (std::size_t trial = 0; trial < values.size(); ++trial) values[trial] -= ratio * back[trial];
    return values;
}

Comparison labelled(const Gate& gate, const Effect& effect, const StudyPlan& plan) {
    const Cell& cell = plan.cells[effect.cells.front()];
    const Scene& scene = plan.scenes[cell.scene];
    Comparison row;
    row.scene = scene.name;
    const Method& method = experiment_of(gate).method;
    row.method = method.sampler.empty() ? method.estimator : fmt::format("{} {}", method.sampler, method.estimator);
    const auto same = [&](auto value_of) {
        return std::all_of(effect.cells.begin(), effect.cells.end(),
                           [&](std::size_t other) { return value_of(plan.cells[other]) == value_of(cell); });
    };
    if (same([](const Cell& c) { return c.subdivision.m; })) row.patches_per_face = cell.subdivision.per_part();
    if (same([](const Cell& c) { return c.samples_per_patch; }) && cell.samples_per_patch > 0)
        row.samples_per_patch = cell.samples_per_patch;
    const auto label = [&](int face) {
        return face == 0 ? std::string() : scene.faces[static_cast<std::size_t>(face - 1)];
    };
    row.from_face = label(effect.quantity.from);
    row.to_face = effect.quantity.kind == QuantityKind::row_sum ? "sum" : label(effect.quantity.to);
    row.quantity = name(gate.kind);
    row.band = gate.band;
    return row;
}

std::string identity(const StudyPlan& plan, std::size_t cell) {
    return fmt::format("{}|completion={}", plan.cells[cell].canonical,
                       name(plan.spec.methods[plan.cells[cell].method].completion));
}

}  // namespace ff::studies::gates
