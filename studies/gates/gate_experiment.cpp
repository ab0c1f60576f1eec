#include "studies/gates/gate_experiment.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/interval.hpp"
#include "studies/readers/toml_reader.hpp"

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

}  // namespace ff::studies::gates
