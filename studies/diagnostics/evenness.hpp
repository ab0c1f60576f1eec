#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/dependence/correlation.hpp"
#include "studies/analysis/analysis.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Whether a measure of evenness ranks samplers as their errors do: over cells that differ only in the sampler.
struct Evenness {
    std::size_t cell = 0;      ///< one of the cells, for scene, estimator and size
    std::size_t methods = 0;   ///< number of samplers
    std::string_view measure;  ///< name of the measure
    PairClass pair_class = PairClass::other;
    stats::RankCorrelation correlation;  ///< between the measure and the RMSE; positive where uneven points err more
};

/// One result for each scene and estimator, at the largest size of at most 1024 points that enough samplers share. The
/// measures are means over a few sets; samplers whose points cannot be made here are left out. Pure.
std::vector<Evenness> compare_evenness_with_errors(const Analysis& findings);

}  // namespace ff::studies
