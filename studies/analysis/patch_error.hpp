#pragma once

#include "studies/store/store.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies {

/// Where on the faces a method's errors arise: one value for each patch.
struct PatchErrors {
    std::vector<double> rmse;  ///< root mean square error of the factors of each patch, over trials and other faces
    double at_edges = 0;       ///< root mean square over the patches along the edges of the surfaces
    double inside = 0;         ///< the same of all others; 0 where there are none
    std::size_t worst = 0;     ///< patch
};

/// From the patch sums in the store and the exact patch-to-face factors. It applies to the direct estimates, before
/// completion by reciprocity.
/// @return empty without patch sums, trials or exact factors, and for one patch per surface
std::optional<PatchErrors> patch_errors(const Store& store, std::size_t cell);

}  // namespace ff::studies
