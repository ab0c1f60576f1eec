#include "app/commands/definitions.hpp"

#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/gates/gate_commands.hpp"
#include "app/folders/result_files.hpp"

#include <fmt/format.h>

#include <string>

namespace ff::app {

void add_report(ProgramDefinition& program, ReportCommand& command) {
    CommandDefinition& sub = program.command(everyday, "report", "Write the reports of a finished study again");
    sub.option("RESULTS", command.results, "Folder of a study, or its results.sqlite", {.is_required = true});
    sub.option("--format", command.formats,
               fmt::format("{} (default: {})", names_in_words("formats"), fmt::join(usual_formats(), ", ")),
               {.type = "FORMAT", .delimiter = ','});
    sub.option("--pictures", command.pictures,
               "Pictures for svg and pdf: names as 'ffstudy figure' lists them, or how they begin (default: all)",
               {.type = "PICTURE", .delimiter = ','});
    sub.option("--out", command.out, "Folder for the files (default: where the results lie)", {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for report.html", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
    sub.action = [&] { return report(command); };
}

void add_figure(ProgramDefinition& program, FigureCommand& command) {
    CommandDefinition& sub = program.command(everyday, "figure", "Draw one picture of a study for a paper");
    sub.option("RESULTS", command.results, "Folder of a study, or its results.sqlite", {.is_required = true});
    sub.option("PICTURE", command.picture, "Its name, or how that begins (default: list them)");
    sub.option("--methods", command.methods, "Methods, separated by commas (default: all)",
               {.type = "METHOD", .delimiter = ','});
    sub.option("--pairs", command.pairs, "Class of pairs of faces",
               {.type = "CLASS", .choices = {"parallel", "adjacent", "other"}});
    sub.option("--width", command.width, "Width, in mm, cm, in or pt", {.type = "LENGTH", .shows_default = true});
    sub.option("--height", command.height, "Height (default: as the picture has it)", {.type = "LENGTH"});
    sub.option("--font-size", command.font_size, "Size of letters, in points", {.shows_default = true});
    sub.option("--font", command.font, "Family of letters (default: that of reports)", {.type = "FONT"});
    sub.option("--out", command.out, "File: .pdf, .svg or .png (default: PICTURE.pdf)", {.type = "FILE"});
    sub.option("--templates", command.templates, "Folder of custom templates", {.type = "DIR"});
    sub.action = [&] { return figure(command); };
}

void add_compare(ProgramDefinition& program, CompareCommand& command) {
    CommandDefinition& sub =
        program.command(everyday, "compare", "Show two runs side by side: what differs, and how sure that is");
    sub.option("A", command.first, "Folder of a study, or its results.sqlite; of one method: RESULTS:METHOD",
               {.type = "RESULTS", .is_required = true});
    sub.option("B", command.second, "The other", {.type = "RESULTS", .is_required = true});
    sub.option("--out", command.out, "Folder for comparison.md and comparison.html (default: none is written)",
               {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for comparison.html", {.type = "DIR"});
    sub.option("--json", command.json, "Print JSON");
    add_verbosity(sub, command.quiet);
    sub.action = [&] { return compare(command); };
}

void add_merge(ProgramDefinition& program, MergeCommand& command) {
    CommandDefinition& sub = program.command(laboratory, "merge", "Bring the results of shards together");
    sub.option("RESULTS", command.sources, "Folders of the shards, or their results.sqlite", {.is_required = true});
    sub.option("--out", command.out, "Folder for the merged results", {.type = "DIR", .is_required = true});
    add_verbosity(sub, command.quiet);
    sub.action = [&] { return merge(command); };
}

void add_audit(ProgramDefinition& program, AuditCommand& command) {
    CommandDefinition& sub = program.command(laboratory, "audit", "Find contradictions in published tables");
    sub.option("TABLES", command.tables, "Tables file (.json)", {.is_required = true});
    sub.option("--out", command.out, "Folder for audit.md (default: none is written)", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
    sub.action = [&] { return audit(command); };
}

void add_check(ProgramDefinition& program, CheckCommand& command, OutsideOptions& outside) {
    CommandDefinition& sub = add_check_of_files(program, command);
    sub.option("--seed", command.seed, "Seed of all random numbers (default: the file's)",
               {.numbers = Numbers::not_negative});
    sub.option("--fresh-seed", command.fresh_seed, "A new seed, printed", {.excludes = {"--seed"}});
    sub.option("--seed-sweep", command.seed_sweep, "Check with N seeds; report failure rates against alpha",
               {.numbers = Numbers::positive, .excludes = {"--json"}});
    sub.option("--baseline", command.baseline, "Baseline file to compare with",
               {.type = "FILE", .excludes = {"--save-baseline"}});
    add_outside_options(sub, outside, OutsideCodeFrom::files_too);
    sub.option("--threads", command.threads, "Threads; verdicts do not depend on them (default: all cores)");
    sub.action = [&] { return check(command, outside); };
}

void add_list(ProgramDefinition& program, ListCommand& command) {
    CommandDefinition& sub = program.command(everyday, "list", "List samplers, estimators, scenes, studies and so on");
    sub.option("KIND", command.name, listed_kinds_in_words());
    sub.option("--json", command.json, "Print JSON");
    add_outside_options(sub, command.outside, OutsideCodeFrom::plugins);
    sub.action = [&] { return list(command); };
}

void add_explain(ProgramDefinition& program, ListCommand& command) {
    CommandDefinition& sub = program.command(everyday, "explain", "Say what something is, its source, its limits");
    sub.option("NAME", command.name, "A name that 'list' shows, or a scene file");
    sub.option("--json", command.json, "Print JSON");
    add_outside_options(sub, command.outside, OutsideCodeFrom::plugins);
    sub.action = [&] { return explain(command); };
}

void add_points(ProgramDefinition& program, PointsCommand& command) {
    CommandDefinition& sub = program.command(laboratory, "points", "Write a point set, or say how evenly it is spread");
    sub.option("SAMPLER", command.sampler, "A sampler, file:PATH or command:PROGRAM", {.is_required = true});
    sub.option("--n", command.points, "Points", {.shows_default = true});
    sub.option("--d", command.dimension, "Coordinates of a point", {.shows_default = true});
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--trial", command.trial, "Which of the trials, from 0", {.shows_default = true});
    add_outside_options(sub, command.outside, OutsideCodeFrom::command_line);
    sub.option("--out", command.out, "File: .npy, .csv, .dat or .svg (default: none is written)", {.type = "FILE"});
    sub.action = [&] { return points(command); };
}

void add_check_sampler(ProgramDefinition& program, CheckSamplerCommand& command) {
    CommandDefinition& sub =
        program.command(checks, "check-sampler", "Check what any sampler has to keep: pass, fail, inconclusive");
    sub.option("SAMPLER", command.sampler, "A sampler, file:PATH#RANDOMISE or command:PROGRAM", {.is_required = true});
    sub.option("--n", command.points, "Points (default: about 256, or those of the largest file)");
    sub.option("--d", command.dimension, "Coordinates of a point (default: all, at most 4)");
    sub.option("--trials", command.trials, "Trials (default: about a second's)", {.numbers = Numbers::positive});
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--promises", command.promises,
               "What every set is, several after commas: latin, net:T, stratified, lattice (default: it is looked for)",
               {.type = "STRUCTURE", .delimiter = ','});
    add_outside_options(sub, command.outside, OutsideCodeFrom::command_line);
    sub.action = [&] { return check_sampler(command); };
}

}  // namespace ff::app
