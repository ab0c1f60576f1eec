#pragma once

#include "core/geometry/fwd.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ff {

/// The constituents of a configuration, which decide whether it can be a scene.
enum class ConfigurationKind {
    surfaces,  ///< finite surfaces: a scene
    element,   ///< a differential area and a surface: no points to shoot from
    endless,   ///< two-dimensional: surfaces are infinite in one direction
};

/// A pair of surfaces whose form factor is known.
struct Configuration {
    std::string_view id;         ///< short, e.g. "R13"
    std::string_view name;       ///< descriptive, e.g. "coaxial_discs_equal"
    std::string_view summary;    ///< one line, with dimensions
    std::string_view formula;    ///< where the exact value comes from, and what it holds for
    std::string_view reference;  ///< key of docs/references.md
    ConfigurationKind kind = ConfigurationKind::surfaces;
    bool occluded = false;             ///< something stands between parts of the two surfaces
    long double (*exact)() = nullptr;  ///< computes the form factor from the first to the second surface
    /// Makes the scene; null where there is none.
    Scene (*scene)() = nullptr;
    int from = 0;  ///< faces of the scene
    int to = 1;
    std::string_view scene_name = name;  ///< several configurations may be pairs of faces of one scene
};

/// All configurations, in the order in which they are shown.
std::span<const Configuration> configurations();

/// The scene of that name, if the catalogue has it; each is made by one of its configurations.
std::optional<Scene> configuration_scene(std::string_view name);

/// Whether a configuration is a pair of faces of this scene.
bool is_configuration(const Scene& scene, const Configuration& configuration);

/// The number of other faces that share equally what a face does not send to itself: the form factor is F = 1 - n
/// F(from, other). 0 for a configuration of two faces.
int other_faces(const Scene& scene, const Configuration& configuration);

/// Names of all scenes of the catalogue, in its order.
std::vector<std::string_view> configuration_scene_names();

/// The form factor between two faces of a scene of the catalogue or of its families (SceneFamily), where an exact value
/// is known or follows by reciprocity, or by closure where the light that a face does not send to itself is shared
/// equally by other faces.
/// @pre both are indices into scene.faces
std::optional<double> known_form_factor(const Scene& scene, int from_face, int to_face);

/// Why configurations of a kind cannot be estimated; empty for surfaces, which can.
std::string_view why_no_scene(ConfigurationKind kind);

}  // namespace ff
