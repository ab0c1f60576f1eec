#include "app/commands/form_factors/scene_input.hpp"

#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace ff::app {

std::vector<std::string> said_of_mesh(const FormFactorsCommand& command) {
    std::vector<std::string> said;
    if (!command.faces.empty()) said.push_back("faces " + command.faces);
    if (command.closed) said.emplace_back(studies::closed_scene);
    if (command.scale) said.push_back(fmt::format("scale {}", *command.scale));
    if (!command.up.empty()) said.push_back("up " + command.up);
    return said;
}

studies::SceneSource read_source(const FormFactorsCommand& command) {
    const std::string& name = command.scene;
    if (name.empty()) throw UserError("SCENE is missing. See 'ffstudy form_factors --help'.");
    const std::vector<std::string> said = said_of_mesh(command);
    if (!said.empty() && !studies::is_read_as_obj(name))
        throw UserError(fmt::format("--{}: '{}' is neither an OBJ file nor a mesh (only these take it). Leave it out.",
                                    said.front(), name));
    if (command.scale && !studies::is_scale(*command.scale))
        throw UserError(fmt::format("--scale {} (1e-9 to 1e9). Write 0.001 for millimetres.", *command.scale));
    studies::SceneSource source = studies::scene_source(name);
    if (!command.zone.empty()) source.zone = command.zone;
    if (!source.is_file()) {
        if (!std::filesystem::is_regular_file(name)) return source;
        static_cast<void>(studies::read_text_file(name, studies::FileKind::scene));  // says so if it is something else
        throw UserError(fmt::format("{}: its extension names no scene format ({}). Rename it.", name,
                                    studies::scene_extensions_in_words()));
    }
    std::string text = studies::read_scene_file(source.name);
    for (const std::string& comment : said) text = studies::with_obj_comment(text, comment);
    source.text = std::move(text);
    return source;
}

Scene scene_without_mirrors(const studies::SceneSource& source) {
    Scene scene = studies::make_scene(source);
    if (mirrors(scene).empty()) return scene;
    throw UserError(fmt::format(
        "scene '{}': mirrors (pairs are computed one by one, which does not follow reflected light). Make it a study "
        "with estimator = \"ray_shooting\", or leave them out.",
        scene.name));
}

}  // namespace ff::app
