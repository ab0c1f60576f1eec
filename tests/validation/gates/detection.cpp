#include "tests/validation/gates/detection.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "samplers/sampler.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/gates/gate_run.hpp"
#include "studies/run/parallel.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

namespace ff::studies::gates {
namespace {

/// The verdict of one gate of a file with one seed.
Verdict verdict_with_seed(Spec spec, std::size_t gate, std::uint64_t seed) {
    spec.seed = Seed{seed};
    Plan plan = prepare_gate(spec, gate, GatePurpose::check, nullptr);
    plan_trials(spec, plan, {});
    return run_gate(spec, plan, {})->verdict;
}

struct Laboratory {
    const Repetitions& repetitions;
    std::uint64_t seeds;

    /// Verdicts of one gate, by seed.
    [[nodiscard]] std::vector<Verdict> verdicts(const Spec& spec, std::size_t gate) const {
        std::vector<Verdict> found(seeds);
        for_each_index(seeds, repetitions.threads,
                       [&](std::uint64_t i) { found[i] = verdict_with_seed(spec, gate, repetitions.seed.value + i); });
        return found;
    }

    [[nodiscard]] stats::Proportion count(const std::vector<Verdict>& verdicts, Verdict wanted) const {
        return {.hits = static_cast<std::uint64_t>(std::count(verdicts.begin(), verdicts.end(), wanted)),
                .trials = seeds};
    }
};

/// The control if it were not broken.
Method mend(Method method) {
    if (const auto& info = samplers::find(method.sampler).info; info.control) method.sampler = info.unbroken_name;
    if (method.tracer == TracerChoice::leaky) method.tracer = TracerChoice::automatic;
    return method;
}

void measure_controls(const Laboratory& laboratory, const Spec& controls, Detection& detection) {
    detection.caught.title = "Controls";
    detection.caught.text = fmt::format(
        "Every gate of studies/built_in/gates/controls.toml with {} seeds in a row: how often the control fails. The "
        "trials of "
        "each are such that the planned power against this control is at least {:g}.",
        laboratory.seeds, controls.power);
    detection.sound.title = "Their sound counterparts";
    detection.sound.text = "The same gates on the sound methods that the controls break.";
    for (std::size_t i = 0; i < controls.gates.size(); ++i) {
        const Gate& gate = controls.gates[i];
        const std::string what = fmt::format("{} ({})", gate.name, name(gate.kind));
        const auto broken = laboratory.verdicts(controls, i);
        detection.caught.rates.push_back(
            {what, laboratory.count(broken, Verdict::fail), RateClaim::at_least, controls.power});
        Spec mended = controls;
        GateExperiment experiment = experiment_of(gate);
        experiment.method = mend(experiment.method);
        mended.gates[i].experiment = std::make_shared<const GateExperiment>(std::move(experiment));
        const auto sound = laboratory.verdicts(mended, i);
        detection.sound.rates.push_back(
            {"fails: " + what, laboratory.count(sound, Verdict::fail), RateClaim::at_most, controls.alpha});
        detection.sound.rates.push_back(
            {"passes: " + what, laboratory.count(sound, Verdict::pass), RateClaim::at_least, controls.power});
    }
}

/// Random rays on one pair of faces; bias is exactly `bias`, since the reference is moved by it.
Spec edge_gate(double alpha, double bias, double band, std::string estimator = "ray_shooting") {
    Spec spec;
    spec.alpha = alpha;
    spec.looks = 1;
    GateExperiment experiment{.scenes = {scene_source("cube")}, .method = {}};
    experiment.method.name = "edge";
    experiment.method.sampler = samplers::yardstick().name;
    experiment.method.estimator = std::move(estimator);
    experiment.method.sizes = {{.patches_per_face = 1, .samples_per_patch = 1000, .trials = {}}};
    Gate gate;
    gate.name = "edge";
    gate.place = "edge";
    gate.experiment = std::make_shared<const GateExperiment>(experiment);
    gate.pairs = {"1-6"};
    gate.trials = 50;
    gate.against = Against::number;
    gate.reference = *exact_form_factor(built_in_scene("cube"), 0, 5) - bias;
    gate.band = {-band, band};
    spec.gates = {gate};
    return spec;
}

void measure_edges(const Repetitions& repetitions, std::uint64_t seeds, Detection& detection) {
    constexpr double wide = 0.01;  // five standard errors of these trials
    detection.edge.title = "False alarms of whole gates";
    detection.edge.text =
        "From bands file to verdict: 50 trials of 1000 random rays, a new seed each time, the reference shifted so "
        "that the bias is exactly as stated in the row. As above, the rate is α/2 at an end of the band and α for a "
        "point null. The last rows use all three looks: a point null on all 30 pairs together, which share α, and "
        "wrong passes.";
    const Laboratory laboratory{repetitions, 10 * seeds};
    for (const double alpha : {0.05, 0.01}) {
        for (const auto& [text, bias, band, rate] :
             {std::tuple("bias = +band", wide, wide, alpha / 2), std::tuple("bias = -band", -wide, wide, alpha / 2),
              std::tuple("point null", 0.0, narrowest_band, alpha)}) {
            const auto verdicts = laboratory.verdicts(edge_gate(alpha, bias, band), 0);
            detection.edge.rates.push_back({fmt::format("fails at {}, α = {}", text, alpha),
                                            laboratory.count(verdicts, Verdict::fail), RateClaim::equal, rate});
        }
    }
    Spec family = edge_gate(0.05, 0, narrowest_band);
    family.looks = 3;
    family.gates.front().against = Against::exact;
    family.gates.front().pairs = {"all"};
    detection.edge.rates.push_back({"fails at point null in 3 looks, 30 pairs, α = 0.05",
                                    laboratory.count(laboratory.verdicts(family, 0), Verdict::fail), RateClaim::at_most,
                                    family.alpha});
    Spec patient = edge_gate(1e-4, wide, wide);
    patient.looks = 3;
    detection.edge.rates.push_back({"passes at bias = +band in 3 looks, α = 0.0001",
                                    laboratory.count(laboratory.verdicts(patient, 0), Verdict::pass),
                                    RateClaim::at_most, patient.pass_alpha});
}

void measure_refusals(Detection& detection) {
    Spec spec = edge_gate(0.05, 0, 1e-3, "area_kernel");
    Gate& gate = spec.gates.front();
    gate.name = gate.place = "adjacent_kernel";
    gate.against = Against::exact;
    gate.pairs = {"adjacent"};
    try {
        static_cast<void>(prepare_gate(spec, 0, GatePurpose::check, nullptr));
    } catch (const UserError& error) {
        detection.refused.emplace_back(error.what());
    }
}

}  // namespace

Detection measure_detection(const Spec& controls, const Repetitions& repetitions, std::uint64_t seeds) {
    Detection detection;
    measure_controls(Laboratory{repetitions, seeds}, controls, detection);
    measure_edges(repetitions, seeds, detection);
    measure_refusals(detection);
    return detection;
}

}  // namespace ff::studies::gates
