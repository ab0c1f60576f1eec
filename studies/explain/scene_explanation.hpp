#pragma once

#include "core/geometry/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// A pair of faces whose exact form factor is known.
struct ExplainedPair {
    int from = 0;  ///< faces from 0
    int to = 0;
    double exact = 0;
    std::string origin;     ///< the formula, in words
    std::string reference;  ///< key of docs/references.md
};

/// An estimator, and why it cannot be used in a scene.
struct ExplainedEstimator {
    std::string name;
    std::optional<std::string> why_not;
};

/// What a scene is and what can be done with it.
struct SceneExplanation {
    std::vector<double> areas;          ///< of faces
    std::vector<std::size_t> surfaces;  ///< of faces, how many
    std::vector<std::vector<Grid>>
        grids;                         ///< of the surfaces of faces, each that occurs once; empty where none is divided
    std::size_t occluders = 0;         ///< surfaces of no face
    std::vector<ExplainedPair> pairs;  ///< of different faces that face each other, row by row
    std::size_t unknown_pairs = 0;     ///< that face each other, and have no exact value
    std::vector<ExplainedEstimator> estimators;
};

SceneExplanation explain_scene(const Scene& scene);

}  // namespace ff::studies
