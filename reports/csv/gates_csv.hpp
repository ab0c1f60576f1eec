#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <ostream>
#include <span>

namespace ff::reports {

/// verdicts.csv: one row per comparison.
void write_verdicts_csv(std::ostream& out, const studies::gates::CheckResults& check);

/// seed_sweep.csv: one row per gate.
void write_seed_sweep_csv(std::ostream& out, const studies::gates::Spec& spec,
                          std::span<const studies::gates::SeedSweep> sweeps);

}  // namespace ff::reports
