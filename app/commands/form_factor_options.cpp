#include "app/commands/form_factors/form_factor_run.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/commands.hpp"

#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "reports/programs/hand_over.hpp"
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
               "else objects or materials)",
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

void add_form_factors(ProgramDefinition& program) {
    const auto [sub, command] = program.command<FormFactorsCommand>(
        everyday, "form-factors", "All form factors of a scene, each with an interval", form_factors);
    auto& request = command.request;
    sub.option("--load", command.load, "Instead of SCENE: a folder that --out has written", {.type = "DIR"});
    sub.option(
        "SCENE", command.scene,
        fmt::format("cube, box:AxBxC, another built-in scene, or a file ({})", studies::scene_extensions_in_words()));
    add_options_of_scenes(sub, command);
    add_options_of_places(sub, command);
    sub.option("--from", command.from,
               "Only factors from points: point:x,y,z,nx,ny,nz, or a CSV file with these columns",
               {.type = "POINTS",
                .excludes = {"--load", "--tolerance", "--relative", "--drop", "--surroundings", "--level",
                             "--simultaneous", "--seed", "--max-time", "--max-memory", "--max-samples", "--shard",
                             "--dry-run", "--repair", "--randomisations", "--text", "--format"}});
    sub.option("--tolerance", request.tolerance, "Largest half width of an interval", {.shows_default = true});
    sub.option("--relative", request.relative, "Or this share of the factor, where that is more: 0.01 for 1 %");
    sub.option("--drop", request.drop, "Of pairs with factors below this, keep only the sums");
    sub.option("--surroundings", request.surroundings, "Name of an added face that receives what leaves an open scene",
               {.type = "NAME"});
    sub.option("--level", request.level, "Level of the intervals", {.shows_default = true});
    sub.option("--simultaneous", command.whole_matrix, "The level is that of all entries and row sums at once");
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    sub.option("--max-time", command.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully",
               {.type = "TIME"});
    sub.option("--max-memory", command.max_memory, "Memory limit: 500M, 2G; stops gracefully", {.type = "SIZE"});
    sub.option("--max-samples", request.max_samples, "Rays and points in all", {.shows_default = true});
    sub.option("--shard", command.shard, "Sample share I/N of the rows; see 'ffstudy merge'",
               {.type = "I/N", .needs = {"--out"}});
    sub.option("--dry-run", command.dry_run, "Sample a few rows, show expected time, memory and disk");
    sub.option("--repair", request.repair, "Also find the nearest matrix that is closed and reciprocal",
               {.excludes = {"--drop"}});
    sub.option("--out", command.out, "Folder for the matrices (default: none is written)", {.type = "DIR"});
    sub.option("--randomisations", request.randomisations,
               "Also write the 16 values behind each sampled entry (randomisations.npz)",
               {.needs = {"--out"}, .excludes = {"--shard"}});
    sub.option("--text", command.text, "matrix.csv and MatrixMarket files also of more than 4096 faces",
               {.needs = {"--out"}});
    sub.option("--format", command.formats,
               fmt::format("Also files for other programs: {}", reports::program_formats_in_words()),
               {.type = "PROGRAMS", .delimiter = ',', .needs = {"--out"}, .excludes = {"--drop"}});
    settle_by_load(sub, {"--from", "--repair", "--out", "--text", "--format"});
    add_verbosity(sub, command.quiet, "Print errors and warnings only");
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
        throw UserError("--{}: '{}' is neither an OBJ file nor a mesh (only these take it). Leave it out.",
                        said.front(), name);
    if (command.scale && !studies::is_scale(*command.scale))
        throw UserError("--scale {} (1e-9 to 1e9). Write 0.001 for millimetres.", *command.scale);
    studies::SceneSource source = studies::scene_source(name);
    if (!command.zone.empty()) source.zone = command.zone;
    if (!source.is_file()) {
        if (!std::filesystem::is_regular_file(name)) return source;
        static_cast<void>(studies::read_text_file(name, studies::FileKind::scene));  // says so if it is something else
        throw UserError(
            "{}: its extension names no scene format ({}). Give a scene file, or a name of 'ffstudy list "
            "scenes'.",
            name, studies::scene_extensions_in_words());
    }
    std::string text = studies::read_scene_file(source.name);
    for (const std::string& comment : said) text = studies::with_obj_comment(text, comment);
    source.text = std::move(text);
    return source;
}

Scene scene_without_mirrors(const studies::SceneSource& source) {
    Scene scene = studies::make_scene(source);
    if (mirrors(scene).empty()) return scene;
    throw UserError(
        "scene '{}': mirrors (pairs are computed one by one, which does not follow reflected light). Make it a study "
        "with estimator = \"ray_shooting\", or leave them out.",
        scene.name);
}

}  // namespace ff::app
