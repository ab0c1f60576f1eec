#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies {

/// The numbers that define a surface, 13 whatever its shape; for a polygon, independent of its first corner.
std::vector<double> numbers_of(const Surface& surface);

/// A hash of these numbers.
std::uint64_t fingerprint(const Surface& surface);

/// The identity of a scene: its surfaces, independent of the order of their corners.
std::string canonical_of(const Scene& scene);

}  // namespace ff::studies
