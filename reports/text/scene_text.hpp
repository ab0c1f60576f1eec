#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/explain/explain.hpp"

#include <string>

namespace ff::reports {

/// Facts about a scene for a terminal.
struct SceneText {
    std::string summary;  ///< "6 surfaces, closed"
    std::string details;  ///< several lines: faces with areas, exact values with their origin, estimators
};

SceneText scene_text(const Scene& scene, const studies::SceneExplanation& explanation);

}  // namespace ff::reports
