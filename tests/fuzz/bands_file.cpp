// A bands file gives gates that can be planned and, where that takes no time, judged to the end; or a UserError.

#include "studies/verdicts/bands_file.hpp"
#include "core/support/error.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/gates/gate_plan.hpp"
#include "studies/gates/gate_run.hpp"
#include "tests/fuzz/one_input.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using namespace ff::studies;

/// Gates whose pilot or trials take longer than a fuzzer has are planned only.
/// @param patience  seconds left for all gates of the file
void check_to_the_end(gates::Spec spec, std::size_t gate, double& patience) {
    gates::Plan plan = gates::prepare_gate(spec, gate, gates::GatePurpose::check, nullptr);
    plan.trials.assign(plan.study.cells.size(), gates::pilot_trials);
    patience -= gates::expected_seconds(plan);
    if (patience < 0) return;
    spec.max_trials = std::min(spec.max_trials, gates::pilot_trials);
    if (spec.gates[gate].trials.value_or(0) > gates::pilot_trials) return;
    static_cast<void>(gates::plan_trials(spec, plan, {}));
    patience -= gates::expected_seconds(plan);
    if (patience < 0) return;
    const auto result = gates::run_gate(spec, plan, {});
    for (const gates::Comparison& row : result->comparisons) {
        if (row.measurement && !(row.measurement->failing.low <= row.measurement->failing.high)) std::abort();
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const gates::Spec spec =
            gates::parse_bands({reinterpret_cast<const char*>(data), size}, "bands.toml", gates::read_experiment);
        double patience = 0.05;
        for (std::size_t gate = 0; gate < spec.gates.size(); ++gate) {
            if (!(spec.gates[gate].band.low <= spec.gates[gate].band.high)) std::abort();
            if (!spec.gates[gate].from_estimates()) check_to_the_end(spec, gate, patience);
        }
    } catch (const ff::UserError&) {
    } catch (const ff::IoError&) {  // a sampler may be a file, which is not there
    }
    return 0;
}
