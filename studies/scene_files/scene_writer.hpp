#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// Whether OBJ and .vs3 can express a scene: all surfaces are polygons, and names of faces are single words.
bool is_of_polygons(const Scene& scene);

/// A scene as the text of a file which the program reads back as the same surfaces and faces; grids are left out where
/// the format has none. Numbers have all their digits. @pre no mirrors; of OBJ and .vs3, is_of_polygons
std::string obj_text(const Scene& scene);
std::string vs3_text(const Scene& scene);
/// @param emissivities  one for each face, where it is known: View3D wants one of each surface, and the others get 0.5
std::string vs3_text(const Scene& scene, const std::vector<std::optional<double>>& emissivities);
std::string toml_scene_text(const Scene& scene);

}  // namespace ff::studies
