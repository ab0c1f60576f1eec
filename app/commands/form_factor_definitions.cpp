#include "app/commands/form_factor_definitions.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/commands.hpp"

#include "reports/programs/hand_over.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

namespace ff::app {
namespace {

/// An option that a loaded matrix has settled.
void of_a_run(OptionDefinition& option) {
    option.rules.excludes.emplace_back("--load");
}

/// What a file does not say itself. @param may_load  the command takes a loaded matrix as well
void add_options_of_scenes(CommandDefinition& sub, FormFactorsCommand& command, bool may_load) {
    OptionDefinition& faces =
        sub.option("--faces", command.faces,
                   "What a face of an OBJ file or a mesh is: group, object, material or polygon (default: groups, or "
                   "else materials)",
                   {.type = "FACES", .choices = {studies::obj_faces.begin(), studies::obj_faces.end()}});
    if (may_load) of_a_run(faces);
    OptionDefinition& closed =
        sub.option("--closed", command.closed, "Treat an OBJ file or a mesh as closed: every ray hits something");
    if (may_load) of_a_run(closed);
    OptionDefinition& zone = sub.option(
        "--zone", command.zone, "Zone or space of an EnergyPlus file (default: its only zone)", {.type = "NAME"});
    if (may_load) of_a_run(zone);
}

/// Where the places of an OBJ file or a mesh are. Heat has a scale of its own, for every scene.
void add_options_of_places(CommandDefinition& sub, FormFactorsCommand& command, bool may_load) {
    OptionDefinition& scale =
        sub.option("--scale", command.scale, "Multiply the lengths of an OBJ file or a mesh: 0.001 for millimetres");
    if (may_load) of_a_run(scale);
    OptionDefinition& up =
        sub.option("--up", command.up, "The axis of an OBJ file or a mesh that points up; it becomes z",
                   {.type = "AXIS", .choices = {studies::obj_axes.begin(), studies::obj_axes.end()}});
    if (may_load) of_a_run(up);
}

}  // namespace

void add_form_factors(ProgramDefinition& program, FormFactorsCommand& command) {
    CommandDefinition& sub =
        program.command(everyday, "form_factors", "All form factors of a scene, each with an interval");
    auto& request = command.request;
    sub.option("--load", command.load, "Instead of SCENE: a folder that --out has written", {.type = "DIR"});
    of_a_run(sub.option(
        "SCENE", command.scene,
        fmt::format("cube, box:AxBxC, another built-in scene, or a file ({})", studies::scene_extensions_in_words())));
    add_options_of_scenes(sub, command, true);
    add_options_of_places(sub, command, true);
    sub.option("--from", command.from,
               "Only factors from points: point:x,y,z,nx,ny,nz, or a CSV file with these columns",
               {.type = "POINTS",
                .excludes = {"--load", "--tolerance", "--relative", "--drop", "--surroundings", "--level",
                             "--simultaneous", "--seed", "--max-time", "--max-memory", "--max-samples", "--shard",
                             "--dry-run", "--repair", "--randomisations", "--text", "--format"}});
    of_a_run(
        sub.option("--tolerance", request.tolerance, "Largest half width of an interval", {.shows_default = true}));
    of_a_run(
        sub.option("--relative", request.relative, "Or this share of the factor, where that is more: 0.01 for 1 %"));
    of_a_run(sub.option("--drop", request.drop, "Of pairs with factors below this, keep only the sums"));
    of_a_run(sub.option("--surroundings", request.surroundings,
                        "Name of an added face that receives what leaves an open scene", {.type = "NAME"}));
    of_a_run(sub.option("--level", request.level, "Level of the intervals", {.shows_default = true}));
    of_a_run(
        sub.option("--simultaneous", command.whole_matrix, "The level is that of all entries and row sums at once"));
    of_a_run(sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true}));
    of_a_run(sub.option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)"));
    of_a_run(sub.option("--max-time", command.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully",
                        {.type = "TIME"}));
    of_a_run(
        sub.option("--max-memory", command.max_memory, "Memory limit: 500M, 2G; stops gracefully", {.type = "SIZE"}));
    of_a_run(sub.option("--max-samples", request.max_samples, "Rays and points in all", {.shows_default = true}));
    of_a_run(sub.option("--shard", command.shard, "Sample share i/n of the rows; see 'ffstudy merge'",
                        {.type = "I/N", .needs = {"--out"}}));
    of_a_run(sub.option("--dry-run", command.dry_run, "Sample a few rows, show expected time, memory and disk"));
    sub.option("--repair", request.repair, "Also find the nearest matrix that is closed and reciprocal",
               {.excludes = {"--drop"}});
    sub.option("--out", command.out, "Folder for the matrices (default: none is written)", {.type = "DIR"});
    of_a_run(sub.option("--randomisations", request.randomisations,
                        "Also write the 16 values behind each sampled entry (randomisations.npz)",
                        {.needs = {"--out"}}));
    sub.option("--text", command.text, "matrix.csv and MatrixMarket files also of more than 4096 faces",
               {.needs = {"--out"}});
    sub.option("--format", command.formats,
               fmt::format("Also files for other programs: {}", reports::program_formats_in_words()),
               {.type = "PROGRAMS", .delimiter = ',', .needs = {"--out"}, .excludes = {"--drop"}});
    add_verbosity(sub, command.quiet, "Print errors and warnings only");
    sub.action = [&] { return form_factors(command); };
}

void add_convert(ProgramDefinition& program, ConvertCommand& command) {
    CommandDefinition& sub = program.command(everyday, "convert", "Write a scene in another format");
    sub.option("SCENE", command.scene.scene,
               fmt::format("A built-in scene, or a file ({})", studies::scene_extensions_in_words()),
               {.is_required = true});
    sub.option("OUT", command.out, "File to write: .obj, .vs3 or .toml", {.type = "FILE", .is_required = true});
    add_options_of_scenes(sub, command.scene, false);
    add_options_of_places(sub, command.scene, false);
    sub.option("--facets", command.facets,
               "Polygons around a full turn of a curved surface (default: it stays curved)");
    add_verbosity(sub, command.scene.quiet, "Print warnings and errors only");
    sub.action = [&] { return convert(command); };
}

void add_heat(ProgramDefinition& program, HeatCommand& command) {
    CommandDefinition& sub =
        program.command(everyday, "heat", "Heat or light between the faces of a scene, with intervals");
    auto& factors = command.factors;
    factors.whole_matrix = true;
    sub.option("--load", factors.load, "Instead of SCENE: a folder that 'form_factors --simultaneous' has written",
               {.type = "DIR"});
    of_a_run(sub.option("SCENE", factors.scene,
                        fmt::format("A built-in scene, or a file ({})", studies::scene_extensions_in_words())));
    add_options_of_scenes(sub, factors, true);
    sub.option("--materials", command.materials, "Materials file (.toml): emissivities and temperatures or fluxes",
               {.type = "FILE", .is_required = true});
    sub.option("--scale", command.scale, "Metres of a unit of length of the scene", {.shows_default = true});
    sub.option("--flow-tolerance", command.flow_tolerance,
               "Of every power: 0.1% of what the sources give off (default), or 40W", {.type = "AMOUNT"});
    of_a_run(sub.option("--tolerance", command.tolerance,
                        "Largest half width of a form factor (default: 1e-4), or of a power (default: 0.1%)",
                        {.type = "AMOUNT"}));
    of_a_run(sub.option("--tolerance-of", command.tolerance_of,
                        "What --tolerance is of: factor, or flux, which samples where powers depend on it",
                        {.type = "WHAT", .choices = {"factor", "flux"}, .shows_default = true}));
    of_a_run(sub.option("--level", factors.request.level, "Level of all intervals at once", {.shows_default = true}));
    of_a_run(sub.option("--seed", factors.seed, "Seed of all random numbers", {.shows_default = true}));
    of_a_run(sub.option("--threads", factors.threads, "Threads; results do not depend on them (default: all cores)"));
    of_a_run(sub.option("--max-time", factors.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully",
                        {.type = "TIME"}));
    of_a_run(
        sub.option("--max-samples", factors.request.max_samples, "Rays and points in all", {.shows_default = true}));
    sub.option("--out", factors.out, "Folder for heat.csv (default: none is written)", {.type = "DIR"});
    sub.option("--gebhart", command.gebhart, "Also Gebhart factors and script-F, in gebhart.csv", {.needs = {"--out"}});
    add_verbosity(sub, factors.quiet, "Print errors and warnings only");
    sub.action = [&] { return heat(command); };
}

void add_enclosure(ProgramDefinition& program, EnclosureCommand& command) {
    CommandDefinition& sub =
        program.command(laboratory, "enclosure", "Light where surfaces see themselves: round rooms, mirrors");
    sub.option("SHAPE", command.name, "cylinder:RxH, cap:RxH, cone:RxH, spheres:RxS, or cube, box:AxBxC",
               {.is_required = true});
    sub.option("--mirror", command.mirror, "The face of a box that is a perfect mirror", {.type = "FACE"});
    sub.option("--reflectance", command.light.reflectance,
               "Reflectances, each solved for separately (default: 0.1,0.5,0.9,0.99,0.999)", {.type = "LIST"});
    sub.option("--emission", command.light.emission,
               "Emitted exitance, one number or one for each surface (default: 1 on the last)", {.type = "LIST"});
    sub.option("--trials", command.trials, "Trials of rays drawn from the exact factors (default: 0)");
    sub.option("--rays", command.rays, "Rays from each surface in a trial", {.shows_default = true});
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--out", command.out, "Folder for enclosure.md and the matrices (default: none is written)",
               {.type = "DIR"});
    add_verbosity(sub, command.quiet);
    sub.action = [&] { return enclosure(command); };
}

}  // namespace ff::app
