#include "studies/gates/gate_trials.hpp"

#include "core/support/contract.hpp"
#include "studies/run/run.hpp"

namespace ff::studies::gates {

Trials::Trials(const StudyPlan& plan) : plan_(&plan), cells_(plan.cells.size()) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        const std::size_t faces = plan.scenes[plan.cells[cell].scene].faces.size();
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
        const std::size_t faces = plan_->scenes[plan_->cells[cell].scene].faces.size();
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
    const auto faces = static_cast<int>(plan_->scenes[plan_->cells[cell].scene].faces.size());
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

}  // namespace ff::studies::gates
