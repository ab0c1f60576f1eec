#pragma once

#include "studies/scene_files/scene_file.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::heat {

/// Properties of a grey diffuse face. Heat: `emissivity` with `temperature` or `flux`. Light: `reflectance` with
/// `emission`.
struct Material {
    std::optional<double> emissivity;   ///< above 0, at most 1
    std::optional<double> temperature;  ///< K
    std::optional<double> flux;         ///< W/m², net, out of the face; 0 is adiabatic
    std::optional<double> reflectance;  ///< from 0, below 1
    std::optional<double> emission;     ///< emitted exitance, in any unit; 0 unless given

    [[nodiscard]] bool is_light() const { return reflectance.has_value(); }
    [[nodiscard]] double reflected() const { return is_light() ? *reflectance : 1 - *emissivity; }
    /// Share of the irradiation. (1 - reflected() would keep only the first digits of a small emissivity.)
    [[nodiscard]] double absorbed() const { return is_light() ? 1 - *reflectance : *emissivity; }
};

/// Faces whose powers are added up.
struct FaceGroup {
    std::string name;
    std::vector<std::size_t> faces;  ///< ascending
};

/// The materials of a scene.
struct Materials {
    std::string name;                    ///< of the case; empty where the file has only one
    std::vector<Material> faces;         ///< in the order of the scene's faces; all heat, or all light
    std::optional<double> surroundings;  ///< K; for light the radiosity of the surroundings
    std::vector<FaceGroup> groups;       ///< those of `[groups]`; without it, the faces of each entry
    bool has_named_groups = false;       ///< the file has `[groups]`
    std::vector<std::string> warnings;   ///< temperatures that are probably in other units

    [[nodiscard]] bool are_light() const { return !faces.empty() && faces.front().is_light(); }
};

/// The faces of a scene, with materials from its file.
struct NamedFaces {
    const std::vector<std::string>& names;
    const std::vector<FaceMaterial>& said;  ///< empty: the file states none
};

/// The emissivity that a scene file gives a face, if it is unique.
std::optional<double> said_emissivity(const std::vector<FaceMaterial>& said, std::size_t face);

/// The same for all of the first faces of a scene.
std::vector<std::optional<double>> said_emissivities(const SceneSource& source, std::size_t faces);

/// Reads a materials file (docs/heat.md): `[materials]` has a name or a pattern with * for each entry. A face's own
/// name takes precedence over its material in the scene file, and that over patterns. Omitted emissivities are taken
/// from the scene file. Each `[[case]]` changes some of these entries.
/// @return the materials of each case, at least one
/// @throws UserError with the place, and the face with no material, two, or an incomplete one
std::vector<Materials> read_cases(std::string_view toml, std::string_view origin, const NamedFaces& faces);

}  // namespace ff::studies::heat
