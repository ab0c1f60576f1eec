#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/form_factors/form_factor_run.hpp"

#include "reports/programs/hand_over.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

namespace ff::app {

void add_form_factors(ProgramDefinition& program) {
    const auto [sub, command] = program.command<FormFactorsCommand>(
        everyday, "form-factors", "All form factors of a scene, each with an interval", form_factors);
    sub.former_name = "form_factors";
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
    sub.option("--shard", command.shard, "Sample share i/n of the rows; see 'ffstudy merge'",
               {.type = "I/N", .needs = {"--out"}});
    sub.option("--dry-run", command.dry_run, "Sample a few rows, show expected time, memory and disk");
    sub.option("--repair", request.repair, "Also find the nearest matrix that is closed and reciprocal",
               {.excludes = {"--drop"}});
    sub.option("--out", command.out, "Folder for the matrices (default: none is written)", {.type = "DIR"});
    sub.option("--randomisations", request.randomisations,
               "Also write the 16 values behind each sampled entry (randomisations.npz)", {.needs = {"--out"}});
    sub.option("--text", command.text, "matrix.csv and MatrixMarket files also of more than 4096 faces",
               {.needs = {"--out"}});
    sub.option("--format", command.formats,
               fmt::format("Also files for other programs: {}", reports::program_formats_in_words()),
               {.type = "PROGRAMS", .delimiter = ',', .needs = {"--out"}, .excludes = {"--drop"}});
    settle_by_load(sub, {"--from", "--repair", "--out", "--text", "--format"});
    add_verbosity(sub, command.quiet, "Print errors and warnings only");
}

}  // namespace ff::app
