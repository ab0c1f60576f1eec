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

/// Formats without a unit of length of their own, or in metres.
constexpr std::array<std::string_view, 5> mesh_extensions{".stl", ".ply", ".off", ".gltf", ".glb"};

SceneWithMaterials scene_without_mirrors(const SceneSource& source) {
    const std::string& name = source.name;
    if (!source.is_file()) return {built_in_scene(name), {}};
    if (!source.text) {
        throw UserError(
            fmt::format("scene '{}' (scene files can be named by study files only). Take cube or box:AxBxC.", name));
    }
    if (name.ends_with(".obj")) return read_obj_scene(name, *source.text);
    if (names_mesh(name)) return read_obj_scene(fmt::format("{} as OBJ", name), *source.text);
    if (name.ends_with(".vs3")) return read_vs3_scene(name, *source.text);
    return read_toml_scene(name, *source.text);
}

}  // namespace

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

SceneWithMaterials make_scene_with_materials(const SceneSource& source) {
    SceneWithMaterials made = scene_without_mirrors(source);
    made.scene = with_mirrors(std::move(made.scene), source.mirrors);
    made.scene.name = source.title();
    return made;
}

Scene make_scene(const SceneSource& source) {
    return make_scene_with_materials(source).scene;
}

Scene make_scene(std::string_view title) {
    return make_scene(scene_source(title));
}

}  // namespace ff::studies
