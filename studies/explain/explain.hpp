#pragma once

#include "core/geometry/subdivision.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A description for `ffstudy list` and `ffstudy explain`.
struct Description {
    std::string_view name;
    std::string_view summary;
    std::string_view details;
    std::string_view reference;  ///< key of docs/references.md
};

/// The choices of a study file besides samplers.
struct Choices {
    std::string_view kind;    ///< "estimator"
    std::string_view plural;  ///< "estimators"
    std::span<const Description> descriptions;
};

/// Estimators, scenes, and the values of a method's keys `completion`, `allocation`, `map` and `tracer`.
std::span<const Choices> all_choices();

/// Something that is broken on purpose and can be named in study and bands files, so that checks can be shown to catch
/// it.
struct Control {
    std::string_view kind;  ///< "sampler", "tracer" or "combination"
    Description description;
};

/// All controls. None of them is in an ordinary listing.
std::vector<Control> controls();

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

/// A description of a scene and of what can be done with it.
struct SceneExplanation {
    std::vector<double> areas;             ///< area of each face, in squared units of length
    std::vector<std::size_t> surfaces;     ///< number of surfaces of each face
    std::vector<std::vector<Grid>> grids;  ///< different grids of the surfaces of faces; empty where none is divided
    std::size_t occluders = 0;             ///< surfaces that belong to no face
    std::vector<ExplainedPair> pairs;      ///< pairs of different faces that face each other, row by row
    std::size_t unknown_pairs = 0;         ///< pairs that face each other, without an exact value
    std::vector<ExplainedEstimator> estimators;
};

SceneExplanation explain_scene(const Scene& scene);

}  // namespace ff::studies
