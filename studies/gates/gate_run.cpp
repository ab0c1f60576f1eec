#include "studies/gates/gate_run.hpp"

#include "core/support/contract.hpp"

#include <fmt/format.h>

namespace ff::studies::gates {
namespace {

std::vector<CellEstimates> all_estimates(const Trials& trials, const Plan& plan) {
    std::vector<CellEstimates> estimates;
    for (std::size_t cell = 0; cell < plan.study.cells.size(); ++cell) estimates.push_back(trials.estimates(cell));
    return estimates;
}

std::string note_of(const Spec& spec, const Plan& plan, const GateResult& result) {
    const std::string& decisive_note = decisive(result.comparisons).note;
    if (result.verdict != Verdict::inconclusive || !decisive_note.empty()) return decisive_note;
    if (plan.wanted_trials > 0)
        return fmt::format("needs {:.3g} trials a look; max_trials allows {}", plan.wanted_trials, spec.max_trials);
    return fmt::format("undecided after {} look{}", result.looks, result.looks == 1 ? "" : "s");
}

}  // namespace

std::optional<GateResult> run_gate(const Spec& spec, const Plan& plan, const GateRunOptions& options) {
    FF_EXPECT(plan.trials.size() == plan.study.cells.size());
    const Gate& gate = spec.gates[plan.gate];
    GateResult result;
    result.gate = gate.name;
    result.kind = gate.kind;
    Trials trials(plan.study);
    const std::uint64_t looks = plan.deterministic ? 1 : spec.looks;
    for (result.looks = 1;; ++result.looks) {
        std::vector<std::uint64_t> wanted = plan.trials;
        for (std::uint64_t& count : wanted) count *= result.looks;
        if (!trials.extend(wanted, options)) return std::nullopt;
        result.comparisons = compare(gate, plan, all_estimates(trials, plan));
        result.verdict = verdict_of(result.comparisons);
        if (result.verdict != Verdict::inconclusive || result.looks == looks) break;
    }
    result.evaluations = trials.evaluations();
    result.note = note_of(spec, plan, result);
    return result;
}

std::optional<StoredGate> run_to_store(const Spec& spec, const Plan& plan, const GateRunOptions& options) {
    FF_EXPECT(plan.purpose == GatePurpose::save_baseline);
    const Gate& gate = spec.gates[plan.gate];
    Trials trials(plan.study);
    if (!trials.extend(plan.trials, options)) return std::nullopt;
    const auto estimates = all_estimates(trials, plan);
    StoredGate stored;
    stored.gate = gate.name;
    for (const Effect& effect : plan.effects) {
        const std::size_t cell = effect.cells.front();
        const Scene& scene = plan.study.scenes[plan.study.cells[cell].scene];
        stored.quantities.push_back(store_quantity(identity(plan.study, cell), effect.quantity,
                                                   series(gate.kind, effect, estimates[cell], scene), effect.truth));
    }
    return stored;
}

}  // namespace ff::studies::gates
