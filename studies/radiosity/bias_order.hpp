#pragma once

#include "stats/basics/interval.hpp"
#include "studies/radiosity/consequences.hpp"
#include "studies/store/store.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::radiosity {

/// How the bias of the exitance, all faces together by area, falls along a ladder of sizes. Exitance is not linear in
/// the form factors: unbiased factors with errors of variance 1/N give it a bias of order 1/N.
struct BiasOrder {
    std::string label;  ///< label of the ladder
    std::size_t scene = 0;
    Treatment treatment = Treatment::direct;
    std::size_t setting = 0;
    struct Point {
        std::size_t cell = 0;
        double evaluations = 0;  ///< N, for a face
        double bias = 0;         ///< relative to the exact value
        double error = 0;        ///< its standard error
    };
    std::vector<Point> points;
    /// Slope of ln |bias| over ln N, by weighted least squares. Empty where at some size the bias is within three
    /// standard errors of 0: its logarithm would be meaningless.
    std::optional<double> slope;
    std::optional<stats::Interval> interval;
};

/// For ladders of sampled methods with growing numbers of samples: one result per treatment and setting, where the
/// exitance has a mean and varies by more than rounding at every size.
std::vector<BiasOrder> bias_orders(const StudyPlan& plan, const Results& results);

}  // namespace ff::studies::radiosity
