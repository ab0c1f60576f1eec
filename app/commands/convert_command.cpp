#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/form_factors/form_factor_run.hpp"
#include "app/terminal/output.hpp"

#include "core/geometry/facets.hpp"
#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "reports/text/numbers.hpp"
#include "studies/heat/materials.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/scene_files/scene_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace ff::app {
namespace {

/// Options of `ffstudy convert`.
struct ConvertCommand {
    FormFactorsCommand scene;  ///< the scene and how it is read
    std::filesystem::path out;
    std::optional<std::size_t> facets;  ///< polygons around a curved surface; empty: it stays as it is
};

/// A format that scenes are written in.
struct SceneFormat {
    std::string_view extension;
    std::string (*text)(const Scene& scene);
    bool holds_curves;
};

constexpr std::array scene_formats{SceneFormat{".obj", studies::obj_text, false},
                                   SceneFormat{".vs3", studies::vs3_text, false},
                                   SceneFormat{".toml", studies::toml_scene_text, true}};

const SceneFormat& format_of(const std::filesystem::path& file) {
    for (const SceneFormat& format : scene_formats) {
        if (studies::has_extension(file.string(), format.extension)) return format;
    }
    throw UserError(
        "{}: its extension names no format that scenes are written in (.obj, .vs3, .toml). "
        "Choose one of them.",
        file.string());
}

/// Names with no other meaning in OBJ and View3D: without blanks and special characters, and not the name of occluders.
void make_words_of_names(Scene& scene) {
    std::size_t changed = 0;
    for (std::string& face : scene.faces) {
        const std::string before = face;
        std::replace_if(
            face.begin(), face.end(),
            [](char c) { return std::string_view(" \t#!,\\").find(c) != std::string_view::npos; }, '_');
        if (face == studies::occluder_group) face += "_";
        const std::string word = face;
        for (std::size_t k = 2; face != before && std::count(scene.faces.begin(), scene.faces.end(), face) > 1; ++k)
            face = fmt::format("{}.{}", word, k);
        changed += face != before ? 1U : 0U;
    }
    if (changed > 0)
        say("note: {} changed, since blanks and special characters mean something else there.\n",
            changed == 1 ? "1 name was" : fmt::format("{} names were", changed));
}

ExitCode convert(const ConvertCommand& command) {
    const SceneFormat& format = format_of(command.out);
    if (command.facets && (*command.facets < 3 || *command.facets > 10000))
        throw UserError("--facets {} (3 to 10000 polygons around a full turn). Try 32.", *command.facets);
    if (std::error_code none; std::filesystem::equivalent(command.scene.scene, command.out, none))
        throw UserError("{}: is the scene itself (it would be replaced). Give another name.", command.out.string());
    const auto prepared = prepare_form_factors(command.scene);
    Scene scene = prepared.scene;
    studies::expect_no_masks(scene);
    if (!command.scene.quiet) {
        for (const std::string& note : studies::examine_scene(scene).notes) say("note: {}\n", note);
    }
    if (command.facets) {
        FacetedScene faceted = with_facets(scene, *command.facets);
        scene = std::move(faceted.scene);
        if (faceted.curved > 0)
            say("note: {} became polygons that are off by at most {}.\n",
                reports::counted(faceted.curved, "curved surface"), reports::brief(faceted.deviation, 3));
    }
    if (!format.holds_curves) {
        make_words_of_names(scene);
        if (!studies::is_of_polygons(scene))
            throw UserError(
                "{}: scene '{}' has curved surfaces ({} holds polygons only). Add --facets 32, "
                "or write .toml.",
                command.out.string(), scene.name, format.extension);
    }
    std::string text;
    if (format.extension == ".vs3") {
        const auto emissivities = studies::heat::said_emissivities(prepared.source, scene.faces.size());
        if (!command.scene.quiet)
            note_unknown_emissivities(emissivities, fmt::format("0.5 in {}", command.out.string()));
        text = studies::vs3_text(scene, emissivities);
    } else {
        text = format.text(scene);
    }
    reports::write_file(command.out, [&](std::ostream& out) { out << text; });
    if (!command.scene.quiet)
        print_folded("{}: {} of {}\n", command.out.string(), reports::counted(scene.faces.size(), "face"),
                     reports::counted(scene.surfaces.size(), "surface"));
    return ExitCode::passed;
}

}  // namespace

void add_convert(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<ConvertCommand>(everyday, "convert", "Write a scene in another format", convert);
    sub.option("SCENE", command.scene.scene,
               fmt::format("A built-in scene, or a file ({})", studies::scene_extensions_in_words()),
               {.is_required = true});
    sub.option("OUT", command.out, "File to write: .obj, .vs3 or .toml", {.type = "FILE", .is_required = true});
    add_options_of_scenes(sub, command.scene);
    add_options_of_places(sub, command.scene);
    sub.option("--facets", command.facets, "Facets per full turn of a curved surface (default: it stays curved)");
    add_verbosity(sub, command.scene.quiet, "Print errors and warnings only");
}

}  // namespace ff::app
