#pragma once

#include "core/estimators/estimator.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <span>

namespace ff {

/// A patch that points are laid on.
struct SourcePatch {
    std::uint32_t surface = 0;  ///< index into Scene::surfaces
    Grid grid = undivided;
    std::uint32_t index = 0;  ///< position in the grid
};

/// Adds to `sums`, by surface of the scene, the sum over the points of a block of weight * (the form factor from the
/// point to that surface).
using SourceSum = std::function<void(const SourcePatch& patch, const WeightedBlock& block, std::span<double> sums)>;

/// One trial of an estimator whose points serve a patch of the source and all that it sees: face-to-face factors, every
/// entry estimated directly. Streams are keyed as in `ray_shooting`: by source patch, or by part of a grid with
/// Allocation::face. Sums run in a fixed order.
/// @pre weights are equal with Allocation::face
Eigen::MatrixXd average_over_sources(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                     const SourceSum& sum);

}  // namespace ff
