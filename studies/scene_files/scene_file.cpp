#include "studies/scene_files/scene_file.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ff::studies {
namespace {

/// A scene's name takes this, and the faces that are mirrors, behind it.
constexpr std::string_view before_mirrors = " mirrors:";
constexpr char between_mirrors = '+';
/// Formats without a unit of length of their own, or in metres.
constexpr std::array<std::string_view, 5> mesh_extensions{".stl", ".ply", ".off", ".gltf", ".glb"};

/// The first line: the name, with mirrors.
std::string_view title_of(std::string_view scene) {
    return scene.substr(0, scene.find('\n'));
}

std::string_view name_of(std::string_view scene) {
    const std::string_view title = title_of(scene);
    return title.substr(0, title.rfind(before_mirrors));
}

std::vector<std::string> mirrors_of(std::string_view scene) {
    const std::string_view title = title_of(scene);
    const std::size_t at = title.rfind(before_mirrors);
    std::vector<std::string> faces;
    if (at == std::string_view::npos) return faces;
    std::string_view left = title.substr(at + before_mirrors.size());
    while (true) {
        const std::size_t end = left.find(between_mirrors);
        faces.emplace_back(left.substr(0, end));
        if (end == std::string_view::npos) return faces;
        left.remove_prefix(end + 1);
    }
}

SceneWithMaterials scene_without_mirrors(std::string_view scene) {
    const std::string_view name = name_of(scene);
    if (!names_scene_file(scene)) return {built_in_scene(name), {}};
    if (!has_scene_text(scene)) {
        throw UserError(
            fmt::format("scene '{}' (a scene file is read with the study file that names it; here only cube and "
                        "box:AxBxC will do).",
                        name));
    }
    const std::string_view text = scene.substr(title_of(scene).size() + 1);
    if (name.ends_with(".obj")) return read_obj_scene(name, text);
    if (names_mesh(name)) return read_obj_scene(fmt::format("{} as OBJ", name), text);
    if (name.ends_with(".vs3")) return read_vs3_scene(name, text);
    return read_toml_scene(name, text);
}

}  // namespace

bool names_scene_file(std::string_view scene) {
    const std::string_view name = name_of(scene);
    return name.ends_with(".toml") || name.ends_with(".obj") || name.ends_with(".vs3") || names_mesh(name);
}

std::string scene_extensions_in_words() {
    return fmt::format(".obj, .toml, .vs3, {}", fmt::join(mesh_extensions, ", "));
}

std::string read_scene_file(const std::filesystem::path& file) {
    return names_mesh(file.string()) ? mesh_as_obj(file) : read_text_file(file, FileKind::scene);
}

bool names_mesh(std::string_view name) {
    return std::any_of(mesh_extensions.begin(), mesh_extensions.end(),
                       [&](std::string_view extension) { return name.ends_with(extension); });
}

bool is_read_as_obj(std::string_view name) {
    return name.ends_with(".obj") || names_mesh(name);
}

bool has_scene_text(std::string_view scene) {
    return scene.find('\n') != std::string_view::npos;
}

std::string with_scene_text(std::string_view name, std::string_view text) {
    FF_EXPECT(!has_scene_text(name));
    return fmt::format("{}\n{}", name, text);
}

std::string scene_file(std::string_view scene) {
    return std::string(name_of(scene));
}

std::string with_mirrors_named(std::string_view scene, const std::vector<std::string>& faces) {
    FF_EXPECT(!has_scene_text(scene));
    return fmt::format("{}{}{}", scene, before_mirrors, fmt::join(faces, std::string_view(&between_mirrors, 1)));
}

SceneWithMaterials make_scene_with_materials(std::string_view scene) {
    SceneWithMaterials made = scene_without_mirrors(scene);
    made.scene = with_mirrors(std::move(made.scene), mirrors_of(scene));
    made.scene.name = title_of(scene);
    return made;
}

Scene make_scene(std::string_view scene) {
    return make_scene_with_materials(scene).scene;
}

}  // namespace ff::studies
