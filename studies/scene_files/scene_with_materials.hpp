#pragma once

#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <vector>

namespace ff::studies {

/// A scene, and what its file states besides.
struct SceneWithMaterials {
    Scene scene;
    std::vector<FaceMaterial> materials;  ///< one for each face and mask, in their order; empty where the file has none
    double scale = 1;                     ///< that lengths were multiplied by, as the file requests
};

}  // namespace ff::studies
