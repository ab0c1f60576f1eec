#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// What is known of a grey diffuse face. Heat: `emissivity` with `temperature` or `flux`. Light: `reflectance` with
/// `emission`.
struct Material {
    std::optional<double> emissivity;   ///< above 0, at most 1
    std::optional<double> temperature;  ///< K
    std::optional<double> flux;         ///< W/m², net, out of the face; 0 is adiabatic
    std::optional<double> reflectance;  ///< from 0, below 1
    std::optional<double> emission;     ///< emitted exitance, in any unit; 0 unless given

    [[nodiscard]] bool is_light() const { return reflectance.has_value(); }
};

/// The materials of a scene.
struct Materials {
    std::vector<Material> faces;         ///< in the order of the scene's faces; all heat, or all light
    std::optional<double> surroundings;  ///< K; for light the radiosity of what lies around
    std::vector<std::string> warnings;   ///< temperatures that are likely meant in other units

    [[nodiscard]] bool are_light() const { return !faces.empty() && faces.front().is_light(); }
};

/// Reads a materials file (docs/heat.md): `[materials]` has a face's name, or a pattern with *, for each entry; a name
/// goes before patterns. @param faces of the scene
/// @throws UserError that names the place, and the face that has no material, two, or an incomplete one
Materials read_materials(std::string_view toml, std::string_view origin, const std::vector<std::string>& faces);

Materials load_materials(const std::filesystem::path& file, const std::vector<std::string>& faces);

}  // namespace ff::studies
