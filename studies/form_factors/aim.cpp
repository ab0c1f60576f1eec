#include "studies/form_factors/aim.hpp"

#include <algorithm>

namespace ff::studies::form_factors {

std::size_t owner_of(const FacePairs& geometry, std::size_t pair) {
    const FacePair& faces = geometry.pairs[pair];
    return geometry.areas[faces.to] < geometry.areas[faces.from] ? faces.to : faces.from;
}

PairsOfRows pairs_to_sample(const FacePairs& geometry) {
    PairsOfRows rows;
    for (std::size_t pair = 0; pair < geometry.pairs.size(); ++pair) rows[owner_of(geometry, pair)].push_back(pair);
    return rows;
}

double Aim::wanted(std::size_t pair) const {
    const FacePair& faces = geometry.pairs[pair];
    const double tolerance = request.tolerance_between(faces.from, faces.to) * geometry.areas[owner(pair)];
    const double width = std::max(tolerance, request.relative * expected[pair]);
    constexpr double least = 0.1;  // nothing comes near it where bounds are as wide
    return std::max(least * width, width - faces.bound);
}

}  // namespace ff::studies::form_factors
