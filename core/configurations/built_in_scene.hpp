#pragma once

#include "core/geometry/fwd.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace ff {

/// A built-in scene by name: "cube" (the paper's, a = b = c = 6), "box:AxBxC", e.g. "box:2x1x0.5", a scene of the
/// catalogue, or one of its families, e.g. "squares_blocked:0.25".
/// @throws UserError with the known names otherwise
Scene built_in_scene(std::string_view name);

/// Scenes of the catalogue with one free dimension: "squares_blocked:0.25". The obstacle grows or shrinks with
/// it.
struct SceneFamily {
    std::string_view name;     ///< name of its scene in the catalogue
    std::string_view measure;  ///< what the number is
    double least = 0;          ///< allowed values, both ends included
    double most = 0;
    double of_catalogue = 0;  ///< value of the scene in the catalogue
    Scene (*scene)(double measure) = nullptr;
    /// Form factor between two faces; empty where it is not known. For its accuracy see core/configurations/.
    std::optional<long double> (*exact)(double measure, int from_face, int to_face) = nullptr;
};

std::span<const SceneFamily> scene_families();

/// A scene of a family.
struct FamilyMember {
    const SceneFamily* family = nullptr;
    double measure = 0;
};

/// The scene "NAME:NUMBER"; empty unless NAME is a family. The catalogue's scene is the same whether it is named with
/// or without its number.
/// @throws UserError where NUMBER is not a number, or is out of range
std::optional<Scene> family_scene(std::string_view name);

/// Which family a scene belongs to, if any.
std::optional<FamilyMember> family_member(const Scene& scene);

}  // namespace ff
