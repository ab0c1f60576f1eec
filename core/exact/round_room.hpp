#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff {

/// Exchange areas A_i F_ij between the surfaces of a closed convex room of revolution: discs and annuli, walls of
/// cylinders and cones, zones of spheres, one after the other around one axis, all facing inward. A line that passes
/// two rims crosses the discs that these rims bound, so that differences of exchange areas of coaxial discs [howell]
/// C-41 give all pairs, and closure gives what a surface sees of itself. In extended precision where the machine has
/// it: within about 1e-18 of the squared extent.
/// @return empty where the surfaces do not make such a room
std::optional<Eigen::MatrixXd> round_room_exchange(const Scene& scene);

}  // namespace ff
