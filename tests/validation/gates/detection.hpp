#pragma once

#include "studies/verdicts/gate.hpp"
#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies::gates {

/// How often controls are caught, and sound methods are not.
struct Detection {
    RateTable caught;                  ///< how often each control fails its gate
    RateTable sound;                   ///< how often its sound counterpart fails the same gate, and passes it
    RateTable edge;                    ///< gates on the program's own trials with the effect at the end of the band
    std::vector<std::string> refused;  ///< messages of gates refused before anything is run
};

/// Runs every gate of `controls` (studies/built_in/gates/controls.toml), one per control, with `seeds` seeds.
Detection measure_detection(const Spec& controls, const Repetitions& repetitions, std::uint64_t seeds);

}  // namespace ff::studies::gates
