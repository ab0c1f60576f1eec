#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace ff::samplers {

/// Makes one set of numbers in [0, 1), coordinate by coordinate of each point. @pre rows.size() == points * dimension
/// @param set  what it holds is replaced
/// @throws UserError with `origin`, point and coordinate
void set_of_rows(std::span<const double> rows, std::uint64_t points, std::size_t dimension, const std::string& origin,
                 PointSet& set);

}  // namespace ff::samplers
