#pragma once

#include <span>
#include <string_view>

namespace ff {

/// What a configuration consists of; decides whether it can be a scene.
enum class ConfigurationKind {
    surfaces,  ///< finite surfaces: a scene
    element,   ///< from a differential area, which has no points to shoot from
    endless,   ///< two-dimensional: surfaces without end in one direction
};

/// A pair of surfaces whose form factor is known.
struct Configuration {
    std::string_view id;         ///< short, e.g. "R13"
    std::string_view name;       ///< speaking, e.g. "coaxial_discs_equal"
    std::string_view summary;    ///< what, with its measures
    std::string_view formula;    ///< where the exact value comes from, and what it holds for
    std::string_view reference;  ///< key of docs/references.md
    ConfigurationKind kind = ConfigurationKind::surfaces;
    bool occluded = false;             ///< something stands between parts of the two surfaces
    long double (*exact)() = nullptr;  ///< computes the form factor from the first to the second surface
};

/// All of them, in the order in which they are shown.
std::span<const Configuration> configurations();

/// What a kind means for estimating: empty for surfaces, otherwise why there is no scene.
std::string_view why_no_scene(ConfigurationKind kind);

}  // namespace ff
