#pragma once

#include "studies/form_factors/face_pairs.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// A dropped pair needs little memory.
struct DroppedPair {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    float least = 0;
    float most = 0;
};

/// What was found in a visit.
struct Seen {
    std::vector<KnownPair> known;  ///< pairs of faces, one entry for each pair of surfaces
    SampledPairs open;
    std::vector<DroppedPair> dropped;
};

/// Looks at each pair of surfaces that belong to faces. @return what was found, part by part
/// @param known  provides areas and occluders
/// @throws InterruptedError where the request is stopped and there are more pairs than can be kept as unknown
std::vector<Seen> look_at_pairs(const Scene& scene, const FacePairs& known, const Request& request);

}  // namespace ff::studies::form_factors
