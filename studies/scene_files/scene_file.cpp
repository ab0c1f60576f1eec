#include "studies/scene_files/scene_file.hpp"

#include "core/box.hpp"
#include "core/contract.hpp"
#include "core/error.hpp"
#include "studies/scene_files/formats.hpp"

#include <fmt/format.h>

namespace ff::studies {
namespace {

std::string_view name_of(std::string_view scene) {
    return scene.substr(0, scene.find('\n'));
}

}  // namespace

bool names_scene_file(std::string_view scene) {
    const std::string_view name = name_of(scene);
    return name.ends_with(".toml") || name.ends_with(".obj") || name.ends_with(".vs3");
}

bool has_scene_text(std::string_view scene) {
    return scene.find('\n') != std::string_view::npos;
}

std::string with_scene_text(std::string_view name, std::string_view text) {
    FF_EXPECT(!has_scene_text(name));
    return fmt::format("{}\n{}", name, text);
}

Scene make_scene(std::string_view scene) {
    if (!names_scene_file(scene)) return built_in_scene(scene);
    const std::string_view name = name_of(scene);
    if (!has_scene_text(scene)) {
        throw UserError(
            fmt::format("scene '{}' (a scene file is read with the study file that names it; here only cube and "
                        "box:AxBxC will do).",
                        name));
    }
    const std::string_view text = scene.substr(name.size() + 1);
    if (name.ends_with(".obj")) return read_obj_scene(name, text);
    if (name.ends_with(".vs3")) return read_vs3_scene(name, text);
    return read_toml_scene(name, text);
}

}  // namespace ff::studies
