#pragma once

#include "tests/validation/form_factors/coverage.hpp"
#include "tests/validation/rates/measured_rate.hpp"

#include <cstddef>

namespace ff::studies::heat {

/// How often the limits of `find_flows` contain known flows.
struct FlowCoverage {
    form_factors::FormFactorCoverageOptions options;
    RateTable flows;                 ///< all powers and temperatures of a scene at once
    RateTable narrower;              ///< the same with a tenth of the width, for comparison
    RateTable statistical;           ///< statistical intervals, one flow for each seed
    RateTable statistical_narrower;  ///< the same with half the width
    double level = 0;  ///< level of the interval of one rate, such that all hold together with 0.95 (Sidak)

    [[nodiscard]] std::size_t contradictions() const;  ///< rates below the level
};

/// Computes the flows of each scene of the catalogue all of whose form factors are known, and some of which are
/// sampled, with many seeds, and those of the cube, an annulus and a furnace (known_flows.hpp). Faces have different
/// emissivities and temperatures; every third is adiabatic. Exact flows are those of the exact form factors; the limits
/// of the furnace have to contain the interval of its reference.
FlowCoverage measure_flow_coverage(const form_factors::FormFactorCoverageOptions& options);

}  // namespace ff::studies::heat
