#include "app/commands/form_factors/form_factor_options.hpp"

#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace ff::app {

void add_options_of_scenes(CommandDefinition& sub, FormFactorsCommand& command) {
    sub.option("--faces", command.faces,
               "What a face of an OBJ file or a mesh is: group, object, material or polygon (default: groups, or "
               "else materials)",
               {.type = "FACES", .choices = {studies::obj_faces.begin(), studies::obj_faces.end()}});
    sub.option("--closed", command.closed, "Treat an OBJ file or a mesh as closed: every ray hits something");
    sub.option("--zone", command.zone, "Zone or space of an EnergyPlus file (default: its only zone)",
               {.type = "NAME"});
}

void add_options_of_places(CommandDefinition& sub, FormFactorsCommand& command) {
    sub.option("--scale", command.scale, "Multiply the lengths of an OBJ file or a mesh: 0.001 for millimetres");
    sub.option("--up", command.up, "x, y or z: the axis of an OBJ file or a mesh that points up, which becomes z",
               {.type = "AXIS", .choices = {studies::obj_axes.begin(), studies::obj_axes.end()}});
}

void settle_by_load(CommandDefinition& sub, std::initializer_list<std::string_view> others) {
    for (OptionDefinition& option : sub.options) {
        if (option.names != "--load" && std::find(others.begin(), others.end(), option.names) == others.end())
            option.rules.excludes.emplace_back("--load");
    }
}

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
    if (name.empty()) throw UserError("SCENE is missing. See 'ffstudy form-factors --help'.");
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
