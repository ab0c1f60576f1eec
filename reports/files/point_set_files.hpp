#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <filesystem>
#include <functional>
#include <ostream>

namespace ff::reports {

using WritePointSet = std::function<void(std::ostream&, const samplers::PointSet&)>;

/// How the first set is written, by the extension: .npy (n, d) of float64; .csv and .dat, one point per line with all
/// digits; .svg, a square for each pair of coordinates. The first three read back as the same points.
/// @throws UserError for another extension
WritePointSet point_set_format(const std::filesystem::path& file);

}  // namespace ff::reports
