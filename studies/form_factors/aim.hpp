#pragma once

#include "studies/form_factors/face_pairs.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace ff::studies::form_factors {

/// Places in FacePairs::pairs, by the face that owns the pairs.
using PairsOfRows = std::map<std::size_t, std::vector<std::size_t>>;

/// The face of a pair from which samples tell more: the smaller.
std::size_t owner_of(const FacePairs& geometry, std::size_t pair);

/// All pairs that are sampled.
PairsOfRows pairs_to_sample(const FacePairs& geometry);

/// How far sampling has to go.
struct Aim {
    const FacePairs& geometry;
    const Request& request;
    /// Exchange area that is expected of each pair, from the samples so far. It decides on numbers of samples, not on
    /// intervals.
    std::vector<double> expected{};

    [[nodiscard]] std::size_t owner(std::size_t pair) const { return owner_of(geometry, pair); }
    /// What the half width of a pair is to stay below, if its exchange area is as large as expected.
    [[nodiscard]] double wanted(std::size_t pair) const;
};

}  // namespace ff::studies::form_factors
