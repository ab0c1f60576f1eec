#pragma once

#include "core/pair_class.hpp"
#include "stats/interval.hpp"
#include "studies/summary.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// A class of pairs at one size, all its pairs together.
struct ClassErrors {
    std::size_t cell = 0;
    std::uint64_t evaluations = 0;  ///< N, of a face or of a pair of faces
    std::optional<double> rmse;     ///< empty without variance
    std::optional<double> median_abs_error;
    std::optional<double> bias;                        ///< mean over pairs
    std::optional<stats::Interval> bias_interval;      ///< Student's t over trials
    std::optional<double> variance;                    ///< mean over pairs, of one trial
    std::optional<stats::Interval> variance_interval;  ///< log-normal; pairs of one trial may depend on each other
    std::optional<double> efficiency;                  ///< 1 / (variance N)
    std::optional<stats::Interval> efficiency_interval;
};

/// @param errors  [trial * pairs + pair], estimate - exact value
ClassErrors summarise_class(std::span<const double> errors, std::size_t pairs, std::uint64_t evaluations,
                            VarianceStatus variance, double level);

/// Estimate - exact value, [trial * pairs + pair]. @param exact  form factors, faces from 0
std::vector<double> errors_of(const CellEstimates& estimates, std::span<const Quantity> pairs,
                              const Eigen::MatrixXd& exact);

/// Those of the pairs that belong to the class.
std::vector<Quantity> pairs_of_class(const Scene& scene, std::span<const Quantity> pairs, PairClass wanted);

double root_mean_square(std::span<const double> errors);

}  // namespace ff::studies
