#pragma once

#include "core/estimators/estimator.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace ff {

/// A patch of a surface, for estimators that work on pairs of patches.
struct PatchView {
    const Surface* surface = nullptr;
    const SurfaceMap* map = nullptr;
    Grid grid = undivided;
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    double area = 0;

    /// The point at (s, t) in [0, 1]^2; the map preserves ratios of area.
    [[nodiscard]] SurfacePoint at(double s, double t) const {
        return map->at((column + s) / grid.columns, (row + t) / grid.rows);
    }

    /// The corners in order around it, of parallelograms and triangles; at the tip of a triangle two coincide.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> corners() const {
        return {at(0, 0).position, at(1, 0).position, at(1, 1).position, at(0, 1).position};
    }
};

/// The corners counter-clockwise as seen from the side that the patch radiates to.
std::array<Eigen::Vector3d, 4> counter_clockwise(const PatchView& patch);

/// An ordered pair of patches of surfaces that face each other.
struct PatchPair {
    PatchView from;
    PatchView to;
    const std::vector<const Surface*>* blockers = nullptr;  ///< what may stand in between
};

/// Which pairs of surfaces are sampled.
enum class PairsOf {
    all,       ///< all that face each other
    occluded,  ///< pairs that something may stand between; the others count as 0
};

/// The form factor between two patches, and what is claimed of its error.
/// @param stream  `source` and `target` are set to those of the pair
using PairValue = std::function<BoundedValue<double>(const PatchPair& pair, const Stream& stream)>;

/// Between faces.
struct PairAverages {
    Eigen::MatrixXd factors;
    Eigen::MatrixXd claims;
};

/// Averages over ordered pairs of patches. Streams are keyed as in `area_kernel`. Sums run in a fixed order.
PairAverages average_pair_values(const Scene& scene, const EstimatorTask& task, const PairValue& value,
                                 PairsOf pairs = PairsOf::all);

/// The sum over the points of a block of weight * (an estimate of the form factor between two patches).
using PairSum = std::function<double(const PatchPair& pair, const WeightedBlock& block)>;

/// One trial of an estimator whose points serve ordered pairs of patches: face-to-face factors, every entry estimated
/// directly.
Eigen::MatrixXd average_over_pairs(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                   const PairSum& sum, PairsOf pairs = PairsOf::all);

}  // namespace ff
