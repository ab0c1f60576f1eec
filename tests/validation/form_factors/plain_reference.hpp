#pragma once

#include "core/geometry/fwd.hpp"
#include "core/points/stream.hpp"

#include <cstddef>
#include <cstdint>

namespace ff::studies::form_factors {

/// An exchange area with an interval.
struct PlainReference {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// What a reference may take.
struct ReferenceEffort {
    double accuracy = 1e-6;  ///< half width to reach, as a factor from the smaller face
    std::uint32_t randomisations = 8;
    std::uint64_t most_points = 4096;  ///< of a randomisation, a power of two: points are doubled up to this number
    double level = 0.95;
};

/// The exchange area of two surfaces by scrambled Sobol' points on the smaller one, and the exact factor from each to
/// what is seen of the other past all surfaces. Neither cells, lines, rays nor clusters of the code under test have a
/// part in it. The interval is that of the means of the randomisations, longer by their possible skewness
/// (stats/means/mean_test.hpp) and by 1e-12 of the smaller area, for rounding.
/// @pre both surfaces and all others are polygons
PlainReference plain_reference(const Scene& scene, std::size_t from, std::size_t to, const ReferenceEffort& effort,
                               StreamKey key);

}  // namespace ff::studies::form_factors
