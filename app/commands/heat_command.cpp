#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/form_factors/form_factor_run.hpp"
#include "app/folders/output_folder.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "reports/csv/heat_csv.hpp"
#include "reports/files/array_files.hpp"
#include "reports/html/scene_html.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/heat_json.hpp"
#include "reports/terminal/heat_terminal.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/scene_reports.hpp"
#include "studies/form_factors/store/stored_request.hpp"
#include "studies/heat/flow_sampling.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::app {

namespace {

/// Options of `ffstudy heat`.
struct HeatCommand {
    FormFactorsCommand factors;  ///< their level holds for all factors at once
    std::filesystem::path materials;
    std::optional<double> scale;                ///< metres of a unit of length of the scene
    std::optional<std::string> tolerance;       ///< largest error of form factors, or of powers, as typed
    std::string tolerance_of = "factor";        ///< or "flux"
    std::optional<std::string> flow_tolerance;  ///< largest error of powers, where `tolerance` is that of form factors
    std::string interval = "statistical";       ///< or "bound"
    bool all_at_once = false;                   ///< whether the level is that of all statistical intervals
    bool gebhart = false;                       ///< Gebhart factors as well
};

bool has_samples(const studies::form_factors::Matrix& matrix) {
    return std::ranges::any_of(matrix.exchanges, &studies::form_factors::FaceExchange::is_sampled);
}

/// Form factors of an earlier run. @throws UserError also where their intervals hold only one by one
studies::form_factors::KeptMatrix load_of_all_at_once(const FormFactorsCommand& command) {
    auto kept = load_kept_form_factors(command);
    expect_nothing_dropped(kept, "ffstudy heat");
    if (!kept.request.surroundings.empty())
        throw UserError(
            "--load {}: the matrix was made with --surroundings {} (heat takes the surroundings from the "
            "materials file). Make it without.",
            command.load.string(), kept.request.surroundings);
    if (has_samples(kept.matrix) && kept.request.level_of != studies::form_factors::LevelOf::matrix)
        throw UserError(
            "--load {}: the level of its intervals is that of each by itself (flows need all at "
            "once). Run 'ffstudy form-factors' again with --simultaneous.",
            command.load.string());
    return kept;
}

/// The value of the option, or its default.
studies::heat::FlowTolerance flow_tolerance_of(const HeatCommand& command, const studies::heat::Materials& materials) {
    const bool samples_flows = command.tolerance_of == "flux";
    if (samples_flows && command.flow_tolerance)
        throw UserError(
            "--flow-tolerance {}: with --tolerance-of flux (--tolerance is that of flows then). Give "
            "--tolerance alone.",
            *command.flow_tolerance);
    const std::string_view option = samples_flows ? "--tolerance" : "--flow-tolerance";
    const auto& text = samples_flows ? command.tolerance : command.flow_tolerance;
    const auto tolerance = text ? studies::heat::read_flow_tolerance(option, *text) : studies::heat::FlowTolerance{};
    if (tolerance.is_power && materials.are_light())
        throw UserError("{} {} (light is in the units of its emission). Write a share, such as 0.1%.", option, *text);
    return tolerance;
}

/// Gebhart factors depend on reflectances alone.
void expect_one_set_of_reflectances(const std::vector<studies::heat::Materials>& cases,
                                    const std::filesystem::path& file) {
    const auto reflects_alike = [](const auto& a, const auto& b) { return a.reflected() == b.reflected(); };
    for (const auto& one : cases) {
        if (!std::ranges::equal(one.faces, cases.front().faces, reflects_alike))
            throw UserError(
                "--gebhart: the cases '{}' and '{}' of {} have different emissivities (gebhart.csv is of one set). "
                "Keep "
                "one of them.",
                cases.front().name, one.name, file.string());
    }
}

/// Metres per unit of length of the scene. @throws UserError where its file says so itself
double scale_of_flows(const HeatCommand& command, const studies::SceneWithMaterials& made) {
    if (!command.scale) return 1;
    if (!studies::is_scale(*command.scale))
        throw UserError("--scale {} (1e-9 to 1e9 metres). Write 0.001 for millimetres.", *command.scale);
    if (made.scale != 1)
        throw UserError(
            "--scale {}: the file of scene '{}' says 'scale {}' itself, and was read so. Leave the option out.",
            *command.scale, made.scene.name, made.scale);
    return *command.scale;
}

double factor_tolerance_of(const HeatCommand& command) {
    constexpr double by_default = 1e-4;
    if (!command.tolerance) return by_default;
    if (const auto tolerance = parse_bare_number<double>(*command.tolerance)) return *tolerance;
    throw UserError(
        "--tolerance {} (not a number, as a tolerance of form factors is). Write 1e-4, or add "
        "--tolerance-of flux.",
        *command.tolerance);
}

/// The form factors that an earlier run left in the folder; nothing where there are none.
/// @throws UserError where they are of another scene or of other options than those of this run, which would replace
/// them
std::optional<studies::form_factors::KeptMatrix> kept_in_folder(const studies::form_factors::KeptMatrix& kept,
                                                                const std::filesystem::path& folder,
                                                                bool samples_flows) {
    if (!std::filesystem::exists(folder / matrix_store_file)) return std::nullopt;
    FormFactorsCommand command;
    command.load = folder;
    studies::form_factors::KeptMatrix there = load_kept_form_factors(command);
    const std::string difference = samples_flows ? "not sampled for flows"
                                                 : studies::form_factors::difference_between(
                                                       there.source, there.request, kept.source, kept.request);
    if (difference.empty()) return there;
    throw UserError(
        "--out {}: has the form factors of another run ({}). Choose another folder, or the same scene and options.",
        folder.string(), difference);
}

constexpr std::array gebhart_matrices{"gebhart", "gebhart_half_widths", "script_f", "script_f_half_widths"};

std::vector<std::string> gebhart_files() {
    std::vector<std::string> all{"gebhart.csv"};
    for (const std::string name : gebhart_matrices) all.insert(all.end(), {name + ".npz", name + ".mtx"});
    return all;
}

std::vector<std::string> heat_files() {
    std::vector<std::string> all{"heat.csv",     "groups.csv",  "heat.json",
                                 "context.json", "report.html", matrix_store_file};
    const std::vector<std::string> more = gebhart_files();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Both factors row by row, as CSV, and as sparse matrices of their middles and half widths. The last column of those
/// of an open scene is the surroundings'.
void write_gebhart_files(OutputFolder& folder, const Scene& scene,
                         const std::vector<studies::heat::GebhartFactor>& factors) {
    using studies::heat::Bounds;
    using studies::heat::GebhartFactor;
    folder.write("gebhart.csv", [&](std::ostream& file) { reports::write_gebhart_csv(file, scene, factors); });
    const auto rows = static_cast<Eigen::Index>(scene.faces.size());
    const auto columns = static_cast<Eigen::Index>(factors.size()) / rows;
    const auto* name = gebhart_matrices.begin();
    for (const auto quantity : {&GebhartFactor::gebhart, &GebhartFactor::script_f}) {
        for (const auto part : {&Bounds::middle, &Bounds::half_width}) {
            const std::string file = *name++;
            std::vector<Eigen::Triplet<double>> entries;
            for (const GebhartFactor& factor : factors)
                entries.emplace_back(static_cast<int>(factor.from), static_cast<int>(factor.to),
                                     ((factor.*quantity).*part)());
            studies::form_factors::Matrix::Sparse matrix(rows, columns);
            matrix.setFromTriplets(entries.begin(), entries.end());
            folder.write(file + ".npz", [&](std::ostream& out) { reports::write_sparse_npz(out, matrix); });
            folder.write(file + ".mtx",
                         [&](std::ostream& out) { reports::write_sparse_matrix_market(out, matrix, scene.name); });
        }
    }
}

void write_heat_files(OutputFolder& folder, const HeatCommand& command, const studies::form_factors::KeptMatrix& kept,
                      const reports::HeatReport& report, const reports::HeatRequest& request,
                      const std::vector<std::string>& warnings) {
    folder.write("heat.csv", [&](std::ostream& file) { reports::write_heat_csv(file, report); });
    folder.write("groups.csv", [&](std::ostream& file) { reports::write_groups_csv(file, report); });
    for (const std::string& file : gebhart_files()) folder.remove(file);
    if (command.gebhart)
        write_gebhart_files(
            folder, kept.scene,
            studies::heat::find_gebhart_factors(kept.scene, kept.matrix, report.cases.front().materials));
    folder.write("heat.json", reports::heat_json(report, request, warnings));
    folder.write("context.json", reports::context_json(kept.context));
    const reports::FormFactorReport factors{kept.scene, kept.request, kept.matrix};
    folder.write("report.html", reports::scene_html(factors, warnings, &report, reports::program_label(kept.context),
                                                    find_templates({})));
}

/// What is doubtful about materials, each once.
std::vector<std::string> warnings_about(const std::vector<studies::heat::Materials>& cases) {
    std::vector<std::string> warnings;
    for (const auto& one : cases) {
        for (const std::string& warning : one.warnings) {
            if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
        }
    }
    return warnings;
}

ExitCode find_flows(const HeatCommand& command) {
    const bool is_loaded = !command.factors.load.empty();
    if (!is_loaded && command.factors.scene.empty()) throw UserError("SCENE is missing. See 'ffstudy heat --help'.");
    auto kept = is_loaded ? load_of_all_at_once(command.factors) : prepare_form_factors(command.factors);
    studies::expect_no_masks(kept.scene);
    const auto made = studies::make_scene_with_materials(kept.source);
    const double scale = scale_of_flows(command, made);
    const auto file = studies::read_text_file(command.materials, studies::FileKind::materials);
    auto cases = studies::heat::read_cases(file, command.materials.string(), {kept.scene.faces, made.materials});
    const bool samples_flows = !is_loaded && command.tolerance_of == "flux";
    if (samples_flows && cases.size() > 1)
        throw UserError(
            "--tolerance-of flux: {} has {} cases (samples are chosen for one). Leave it out, or keep one case.",
            command.materials.string(), cases.size());
    if (command.gebhart) expect_one_set_of_reflectances(cases, command.materials);
    const studies::heat::FlowTolerance tolerance = flow_tolerance_of(command, cases.front());
    if (!samples_flows && !is_loaded) kept.request.tolerance = factor_tolerance_of(command);
    const studies::heat::FlowIntervals intervals{command.interval == "statistical", kept.request.level,
                                                 command.all_at_once};
    kept.request.randomisations = true;
    std::optional<OutputFolder> out;
    if (!command.factors.out.empty()) out.emplace(command.factors.out, "heat", heat_files());
    std::vector<std::string> warnings = warnings_about(cases);
    for (const std::string& warning : warnings) say("warning: {}\n", warning);
    std::optional<studies::heat::SampledFlows> sampled;
    const auto find = [&](const Scene& scene, const studies::form_factors::Request& request) {
        if (!samples_flows) return studies::form_factors::find_matrix(scene, request);
        sampled = studies::heat::sample_flows(scene, request, cases.front(), scale, tolerance, intervals);
        return std::move(sampled->matrix);
    };
    auto earlier = out ? kept_in_folder(kept, command.factors.out, samples_flows) : std::nullopt;
    const bool is_there = earlier && !is_loaded && !earlier->matrix.interrupted;
    if (is_there) {
        kept = std::move(*earlier);
        if (!command.factors.quiet)
            say("note: the form factors are those of an earlier run in {}.\n", command.factors.out.string());
    }
    if (!is_loaded && !is_there) studies::heat::expect_surroundings(kept.scene, cases);
    const bool by_signal = !is_loaded && !is_there && compute_form_factors(command.factors, kept, find);
    if (sampled) kept.request.tolerance = sampled->factor_tolerance;
    for (const std::string& warning : reports::form_factor_warnings({kept.scene, kept.request, kept.matrix})) {
        say("warning: {}\n", warning);
        warnings.push_back(warning);
    }
    if (out) {
        // Kept before anything about the materials can fail. Factors that were sampled for flows are not reused.
        if (!sampled && !is_there)
            out->replace(matrix_store_file,
                         [&](const auto& store) { studies::form_factors::save_matrix(store, kept); });
    }
    const bool lacks_values = kept.matrix.randomisations.empty() && has_samples(kept.matrix);
    if (intervals.statistical && (is_loaded || is_there) && lacks_values && !command.factors.quiet)
        say("note: {} has no values of randomisations: intervals of flows are bounds. {}\n",
            is_loaded ? command.factors.load.string() : command.factors.out.string(),
            is_loaded ? "Add --randomisations where it is made."
                      : "An earlier version of ffstudy made it; an empty folder gets them.");
    std::vector<studies::heat::SolvedCase> solved;
    if (sampled)
        solved.push_back({std::move(cases.front()), std::move(sampled->flows)});
    else
        solved = studies::heat::solve_cases(kept.scene, kept.matrix, std::move(cases), scale, intervals);
    const bool trusted = studies::form_factors::is_trusted(kept.scene, kept.matrix, kept.request.tolerance);
    const reports::HeatReport report{
        kept.scene, kept.request, solved, tolerance, trusted, sampled ? &*sampled : nullptr, command.all_at_once};
    for (const auto& one : solved) {
        const bool falls_back = intervals.statistical && !one.flows.statistical && has_samples(kept.matrix);
        if (falls_back && !lacks_values && !command.factors.quiet)
            say("note: intervals of flows{} are bounds, since the factors are not known well enough for statistical "
                "ones\n",
                one.materials.name.empty() ? "" : fmt::format(" of case '{}'", one.materials.name));
    }
    if (const auto widened = reports::widened_rows(report)) {
        say("note: {}\n", *widened);
        warnings.push_back(*widened);
    }
    if (!command.factors.quiet) print_folded(reports::heat_text(report, style_of_stdout()));
    if (out) write_heat_files(*out, command, kept, report, {file, scale}, warnings);
    if (by_signal) return ExitCode::interrupted;
    const bool within = std::ranges::all_of(solved, [&](const auto& one) { return one.flows.within(tolerance); });
    return trusted && within ? ExitCode::passed : ExitCode::inconclusive;
}

ExitCode heat(const HeatCommand& command) {
    try {
        return find_flows(command);
    } catch (const studies::heat::InconclusiveFlows& inconclusive) {
        say("ffstudy: {}\n", inconclusive.what());
        return ExitCode::inconclusive;
    }
}

}  // namespace

void add_heat(ProgramDefinition& program) {
    const auto [sub, command] = program.command<HeatCommand>(
        everyday, "heat", "Heat or light between the faces of a scene, with intervals", heat);
    constexpr const char* by_either_name = "--gebhart,--script-f";
    auto& factors = command.factors;
    factors.whole_matrix = true;
    sub.option("--load", factors.load, "Instead of SCENE: a folder of 'heat', or of 'form-factors --simultaneous'",
               {.type = "DIR"});
    sub.option("SCENE", factors.scene,
               fmt::format("A built-in scene, or a file ({})", studies::scene_extensions_in_words()));
    add_options_of_scenes(sub, factors);
    sub.option("--materials", command.materials, "Materials file (.toml): emissivities and temperatures or fluxes",
               {.type = "FILE", .is_required = true});
    sub.option("--scale", command.scale, "Metres of a unit of length of the scene (default: 1)");
    sub.option("--flow-tolerance", command.flow_tolerance,
               "Of every power: 0.1% of what the sources give off (default), or 40W", {.type = "AMOUNT"});
    sub.option("--tolerance", command.tolerance,
               "Largest half width of a form factor (default: 1e-4), or of a power (default: 0.1%)",
               {.type = "AMOUNT"});
    sub.option("--tolerance-of", command.tolerance_of,
               "What --tolerance applies to: factor, or flux (samples where powers depend on it)",
               {.type = "WHAT", .choices = {"factor", "flux"}, .shows_default = true});
    sub.option("--interval", command.interval,
               "Of flows: statistical, from the spread of randomisations, or bound, by all form factors within theirs",
               {.type = "KIND", .choices = {"statistical", "bound"}, .shows_default = true});
    sub.option("--level", factors.request.level, "Level of each interval", {.shows_default = true});
    sub.option("--simultaneous", command.all_at_once, "All intervals hold together at the level, as bounds do");
    sub.option("--seed", factors.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--threads", factors.threads, "Threads; results do not depend on them (default: all cores)");
    sub.option("--max-time", factors.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully",
               {.type = "TIME"});
    sub.option("--max-samples", factors.request.max_samples, "Rays and points in all", {.shows_default = true});
    sub.option("--out", factors.out, "Folder for results and form factors, which the next run reuses (default: none)",
               {.type = "DIR"});
    sub.option(by_either_name, command.gebhart, "Also Gebhart factors and script-F, as CSV and matrices",
               {.needs = {"--out"}});
    settle_by_load(sub, {"--materials", "--scale", "--flow-tolerance", "--out", by_either_name});
    add_verbosity(sub, factors.quiet, "Print errors and warnings only");
}

}  // namespace ff::app
