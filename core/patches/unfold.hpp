#pragma once

#include "core/geometry/subdivision.hpp"

#include <optional>
#include <vector>

namespace ff {

/// A rectangle in the plane, in the scene's unit of length.
struct FlatRectangle {
    double left = 0;
    double bottom = 0;
    double right = 0;
    double top = 0;
};

/// The inside of an empty box laid flat: the first surface in the middle, those that share its edges are folded out
/// around it, and the opposite one lies beyond the right one.
struct UnfoldedBox {
    std::vector<FlatRectangle> patches;   ///< in the order of PatchOrder
    std::vector<FlatRectangle> surfaces;  ///< in the order of the scene
    FlatRectangle extent;
};

/// Empty unless the scene is the inside of an empty box without mirrors and grids.
std::optional<UnfoldedBox> unfold_box(const Scene& scene, Subdivision subdivision);

}  // namespace ff
