// A baseline can be compared with to the end, with verdicts whose numbers are numbers, or it is a UserError.

#include "studies/gates/baseline.hpp"
#include "core/support/error.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/json/gates_json.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/gates/gate_plan.hpp"
#include "studies/gates/gate_run.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "tests/fuzz/no_number.hpp"
#include "tests/fuzz/one_input.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace {

using namespace ff::studies;

/// The bands file with which the seeds were saved.
constexpr std::string_view bands = R"([gates]
looks = 1
max_trials = 40
[[gate]]
name = "b"
kind = "bias"
scene = "cube"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
pairs = "1-6"
trials = 40
reference = "baseline"
band = 1e-2
[[gate]]
name = "s"
kind = "std"
scene = "cube"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
pairs = "1-6"
trials = 40
reference = "baseline"
band = 0.5
[[gate]]
name = "e"
kind = "efficiency"
scene = "cube"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
pairs = "1-6"
band = 0.5
)";

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const gates::Spec spec = gates::parse_bands(bands, "bands.toml", gates::read_experiment);
    try {
        const gates::Baseline baseline =
            gates::parse_baseline({reinterpret_cast<const char*>(data), size}, "base.json");
        gates::CheckResults check{spec, {}};
        for (std::size_t gate = 0; gate < spec.gates.size(); ++gate) {
            try {
                gates::Plan plan = gates::prepare_gate(spec, gate, gates::GatePurpose::check, &baseline);
                static_cast<void>(gates::plan_trials(spec, plan, {}));
                check.results.push_back(gates::run_gate(spec, plan, {}).value());
            } catch (const ff::UserError&) {
            }
        }
        std::ostringstream csv;
        ff::reports::write_verdicts_csv(csv, check);
        if (has_no_number(csv.str()) || has_no_number(ff::reports::verdicts_json(check))) std::abort();
    } catch (const ff::UserError&) {
    }
    return 0;
}
