#pragma once

#include "core/points/stream.hpp"
#include "tests/validation/rates/measured_rate.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies::form_factors {

struct FormFactorCoverageOptions {
    Seed seed{1};  ///< the first seed
    std::uint64_t seeds = 200;
    double tolerance = 0.004;
    double level = 0.95;  ///< level of the intervals
    double shrink = 1;    ///< factor on the width of every sampled interval; below 1: a control to be caught
    unsigned threads = 1;
    bool cells = true;                ///< false: rays instead, whose intervals are less cautious
    std::vector<std::string> scenes;  ///< empty: the whole catalogue
    std::uint64_t adversarial = 0;    ///< random scenes of each kind of trap (adversarial.hpp)
    std::uint64_t walls = 0;          ///< random scenes of two tiled walls (tiled_walls.hpp), at each kind of level
};

/// How often the intervals of `find_matrix` contain known values.
struct FormFactorCoverage {
    FormFactorCoverageOptions options;
    RateTable entries;             ///< each sampled pair of faces of the catalogue
    RateTable matrices;            ///< all known pairs of a scene at once, at LevelOf::matrix
    RateTable adversarial;         ///< random scenes in which points could miss something, pooled
    RateTable facets;              ///< random scenes of many faces (tiled_walls.hpp)
    double level = 0;              ///< level of the interval of one rate, such that all hold together with 0.95 (Sidak)
    std::size_t exact_pairs = 0;   ///< known pairs whose error has a bound, in all runs
    std::size_t exact_missed = 0;  ///< those whose bound did not hold
    std::size_t out_of_tolerance = 0;  ///< runs that missed the tolerance

    /// The tables that were measured, for reports.
    [[nodiscard]] std::vector<const RateTable*> tables() const;
    [[nodiscard]] std::size_t contradictions() const;  ///< rates below the level, and bounds that did not hold
};

/// Computes the matrix of each scene of the catalogue with many seeds, for each entry and for the whole matrix.
FormFactorCoverage measure_form_factor_coverage(const FormFactorCoverageOptions& options);

}  // namespace ff::studies::form_factors
