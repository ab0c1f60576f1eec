#pragma once

#include "core/geometry/scene.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace ff {

/// Scenes of the catalogue with one measure to choose: "squares_blocked:0.25". What stands in the way grows with it, or
/// shrinks.
struct SceneFamily {
    std::string_view name;     ///< of the scene in the catalogue that belongs to it
    std::string_view measure;  ///< what the number is
    double least = 0;          ///< allowed values, both ends included
    double most = 0;
    double of_catalogue = 0;  ///< of the scene in the catalogue
    Scene (*scene)(double measure) = nullptr;
    /// Form factor between two faces; empty where it is not known. Accurate as core/configurations/ says of each.
    std::optional<long double> (*exact)(double measure, int from_face, int to_face) = nullptr;
};

std::span<const SceneFamily> scene_families();

/// A scene of a family.
struct FamilyMember {
    const SceneFamily* family = nullptr;
    double measure = 0;
};

/// The scene "NAME:NUMBER"; empty unless NAME is that of a family. That of the catalogue, by its number, is the same as
/// by its name alone.
/// @throws UserError where NUMBER is none, or not allowed
std::optional<Scene> family_scene(std::string_view name);

/// Which family a scene belongs to, if any.
std::optional<FamilyMember> family_member(const Scene& scene);

}  // namespace ff
