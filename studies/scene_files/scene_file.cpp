#include "studies/scene_files/scene_file.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "core/visibility/mirrors.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ff::studies {
namespace {

/// The name of an EnergyPlus file can be followed by this and the name of a zone.
constexpr std::string_view before_zone = " zone:";
/// The name of a scene can be followed by this and the faces that are mirrors.
constexpr std::string_view before_mirrors = " mirrors:";
constexpr char between_mirrors = '+';

/// Formats without a unit of length of their own, or in metres.
constexpr std::array<std::string_view, 9> mesh_extensions{".stl", ".ply", ".off", ".gltf", ".glb",
                                                          ".vtk", ".vtu", ".vtp", ".msh"};

SceneWithMaterials scene_without_mirrors(const SceneSource& source) {
    const std::string& name = source.name;
    if (!source.zone.empty() && !names_energyplus(name))
        throw UserError("zone '{}': '{}' is no input file of EnergyPlus (others have no zones). Leave it out.",
                        source.zone, name);
    if (!source.is_file()) return {built_in_scene(name), {}, 1};
    if (!source.text) {
        throw UserError("scene '{}' (scene files can be named by study and tables files only). Take cube or box:AxBxC.",
                        name);
    }
    if (is_read_as_obj(name)) return read_obj_scene(name, *source.text);
    if (has_extension(name, ".vs3")) return read_vs3_scene(name, *source.text);
    return read_toml_scene(name, *source.text);
}

}  // namespace

bool SceneSource::is_file() const {
    return is_read_as_obj(name) || has_extension(name, ".toml") || has_extension(name, ".vs3") ||
           names_energyplus(name);
}

std::string SceneSource::title() const {
    std::string place = zone.empty() ? name : fmt::format("{}{}{}", name, before_zone, zone);
    if (mirrors.empty()) return place;
    return fmt::format("{}{}{}", place, before_mirrors, fmt::join(mirrors, std::string_view(&between_mirrors, 1)));
}

std::string SceneSource::written() const {
    return text ? fmt::format("{}\n{}", title(), *text) : title();
}

SceneSource scene_source(std::string_view written) {
    const std::size_t end = written.find('\n');
    if (end != std::string_view::npos) return source_of_file(written.substr(0, end), written.substr(end + 1));
    SceneSource source;
    const std::size_t at = written.rfind(before_mirrors);
    source.name = written.substr(0, at);
    const std::size_t zone = source.name.find(before_zone);
    if (zone != std::string::npos && names_energyplus(source.name.substr(0, zone))) {
        source.zone = source.name.substr(zone + before_zone.size());
        source.name.resize(zone);
    }
    if (at == std::string_view::npos) return source;
    std::string_view left = written.substr(at + before_mirrors.size());
    while (true) {
        const std::size_t next = left.find(between_mirrors);
        source.mirrors.emplace_back(left.substr(0, next));
        if (next == std::string_view::npos) return source;
        left.remove_prefix(next + 1);
    }
}

SceneSource source_of_file(std::string_view title, std::string_view text) {
    SceneSource source = scene_source(title);
    source.text = text;
    return source;
}

bool has_extension(std::string_view name, std::string_view extension) {
    return in_small_letters(name).ends_with(extension);
}

std::string scene_extensions_in_words() {
    return fmt::format(".obj, .toml, .vs3, .idf, .epJSON, {}", fmt::join(mesh_extensions, ", "));
}

std::string read_scene_file(const std::filesystem::path& file) {
    if (names_mesh(file.string())) return mesh_as_obj(file);
    std::string bytes = read_bytes(file);
    expect_no_mesh(file, bytes);
    if (has_extension(file.string(), ".idf")) bytes = energyplus::with_ascii_comments(std::move(bytes));
    return checked_text(std::move(bytes), file, FileKind::scene);
}

bool names_mesh(std::string_view name) {
    return std::any_of(mesh_extensions.begin(), mesh_extensions.end(),
                       [&](std::string_view extension) { return has_extension(name, extension); });
}

bool names_energyplus(std::string_view name) {
    return has_extension(name, ".idf") || has_extension(name, ".epjson");
}

bool is_read_as_obj(std::string_view name) {
    return has_extension(name, ".obj") || names_mesh(name);
}

SceneWithMaterials make_scene_with_materials(const SceneSource& source) {
    SceneSource named = source;
    SceneWithMaterials made;
    if (names_energyplus(source.name) && source.text) {
        ZoneScene read = read_energyplus_scene(source.name, *source.text, source.zone);
        made.scene = std::move(read.scene);
        named.zone = std::move(read.zone);
    } else {
        made = scene_without_mirrors(source);
    }
    made.scene = with_mirrors(std::move(made.scene), source.mirrors);
    made.scene.name = named.title();
    return made;
}

Scene make_scene(const SceneSource& source) {
    return make_scene_with_materials(source).scene;
}

void expect_no_masks(const Scene& scene) {
    if (scene.masks.empty()) return;
    throw UserError(
        "scene '{}': '{}' masks a part of '{}' (only the matrix of ffstudy form-factors allows for masks). Leave it "
        "out.",
        scene.name, scene.masks.front().name, scene.masks.front().base);
}

Scene make_scene(std::string_view title) {
    return make_scene(scene_source(title));
}

}  // namespace ff::studies
