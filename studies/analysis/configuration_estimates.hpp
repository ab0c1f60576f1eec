#pragma once

#include "core/configurations/catalogue.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"

#include <optional>
#include <vector>

namespace ff::studies {

/// The estimate of one cell for a configuration of the catalogue. For a face with itself it follows by closure from the
/// factor to another face.
struct ConfigurationEstimate {
    const Configuration* configuration = nullptr;
    const CellAnalysis* found = nullptr;
    double mean = 0;
    double exact = 0;
    double error = 0;                         ///< standard error; of a deterministic method |mean - exact|
    std::optional<stats::Interval> interval;  ///< interval of the mean, at the study's level; empty unless trials vary
    VarianceStatus variance = VarianceStatus::finite;  ///< why there may be no interval
    double bias = 0;                                   ///< mean - exact
    std::optional<double> standard_errors;             ///< bias in standard errors
};

/// The estimates in the order of the catalogue, then of the cells; empty where no scene is one of the catalogue. They
/// point into `findings`.
std::vector<ConfigurationEstimate> configuration_estimates(const Analysis& findings);

}  // namespace ff::studies
