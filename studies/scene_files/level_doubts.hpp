#pragma once

#include "studies/scene_files/scene_file.hpp"

namespace ff::studies {

/// What surfaces do that lie over each other in one plane, or nearly.
void add_overlaps(const Scene& scene, SceneDoubts& doubts);

}  // namespace ff::studies
