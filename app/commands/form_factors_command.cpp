#include "app/commands/commands.hpp"
#include "app/commands/form_factor_run.hpp"

#include "app/command_line/common_options.hpp"
#include "app/commands/run_context.hpp"
#include "app/folders/output_folder.hpp"
#include "app/folders/result_files.hpp"
#include "app/process/limits.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/messages.hpp"
#include "app/terminal/progress.hpp"
#include "app/terminal/terminal_style.hpp"

#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "reports/csv/form_factors_csv.hpp"
#include "reports/files/matrix_files.hpp"
#include "reports/files/sparse_npz.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/form_factors_json.hpp"
#include "reports/json/json.hpp"
#include "reports/terminal/form_factors_text.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/form_factors/store.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff::app {
namespace {

constexpr const char* store_file = "form_factors.sqlite";
const std::vector<std::string> files{store_file,          "matrix.csv",      "form_factors.mtx", "form_factors.npy",
                                     "form_factors.npz",  "half_widths.mtx", "half_widths.npy",  "half_widths.npz",
                                     "areas.mtx",         "areas.npy",       "repaired.mtx",     "repaired.npy",
                                     "form_factors.json", "context.json"};

/// A built-in name, or name and text of a file.
std::string read_source(const FormFactorsCommand& command) {
    const std::string& name = command.scene;
    const bool by_polygon = command.faces == "polygon";
    if (name.empty()) throw UserError("SCENE is missing. See 'ffstudy form_factors --help'.");
    const bool names_file = studies::names_scene_file(name);
    if (by_polygon && !name.ends_with(".obj"))
        throw UserError(
            fmt::format("--faces polygon: '{}' is no OBJ file (faces of others have names). Leave it out.", name));
    if (!names_file && !std::filesystem::is_regular_file(name)) return name;
    std::string text = studies::read_text_file(studies::scene_file(name), studies::FileKind::scene);
    if (by_polygon) text = studies::with_faces_of_polygons(std::move(text));
    if (names_file) return studies::with_scene_text(name, text);
    throw UserError(fmt::format("{}: its extension names no scene format. Rename it to .obj, .toml or .vs3.", name));
}

Scene make_scene(const std::string& source) {
    Scene scene = studies::make_scene(source);
    if (mirrors(scene).empty()) return scene;
    throw UserError(fmt::format(
        "scene '{}': mirrors (pairs are computed one by one, which does not follow reflected light). Make it a study "
        "with estimator = \"ray_shooting\", or leave them out.",
        scene.name));
}

void write_matrix(OutputFolder& folder, const std::string& file, const Eigen::MatrixXd& matrix,
                  const std::string& comment) {
    folder.write(file + ".mtx", [&](std::ostream& out) { reports::write_sparse_matrix_market(out, matrix, comment); });
    folder.write(file + ".npy", [&](std::ostream& out) { reports::write_npy(out, matrix); });
}

/// Of very many faces without the files in which zeros take room.
void write_matrix(OutputFolder& folder, const std::string& file, const studies::FormFactorMatrix::Sparse& matrix,
                  const std::string& comment) {
    folder.write(file + ".npz", [&](std::ostream& out) { reports::write_sparse_npz(out, matrix); });
    if (matrix.rows() <= static_cast<Eigen::Index>(studies::most_dense_faces))
        write_matrix(folder, file, Eigen::MatrixXd(matrix), comment);
}

void write_files(OutputFolder& folder, const studies::KeptFormFactors& kept) {
    folder.replace(store_file, [&](const auto& file) { studies::save_form_factors(file, kept); });
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    const auto& [scene, request, matrix] = report;
    if (matrix.faces() <= studies::most_dense_faces)
        folder.write("matrix.csv", [&](std::ostream& out) { reports::write_form_factors_csv(out, report); });
    write_matrix(folder, "form_factors", matrix.factors(), scene.name);
    write_matrix(folder, "half_widths", matrix.half_widths(), scene.name);
    write_matrix(folder, "areas",
                 Eigen::Map<const Eigen::VectorXd>(matrix.areas.data(), static_cast<Eigen::Index>(matrix.areas.size())),
                 scene.name);
    if (matrix.repaired && matrix.repaired->possible)
        write_matrix(folder, "repaired", matrix.repaired->factors, scene.name);
    folder.write("form_factors.json", reports::form_factors_json(report));
    folder.write("context.json", reports::context_json(kept.context));
}

studies::FormFactorRequest request_of(const FormFactorsCommand& command) {
    studies::FormFactorRequest request = command.request;
    request.seed = checked_seed(command.seed);
    request.threads = thread_count(command.threads);
    if (command.whole_matrix) request.level_of = studies::LevelOf::matrix;
    request.stop = &stop_flag();
    return request;
}

std::string in_words(const FormFactorsCommand& command) {
    return fmt::format("ffstudy form_factors {}{} --tolerance {} --level {}{} --seed {}{}", command.scene,
                       command.faces == "polygon" ? " --faces polygon" : "", command.request.tolerance,
                       command.request.level, command.whole_matrix ? " --simultaneous" : "", command.seed,
                       command.request.repair ? " --repair" : "");
}

/// Prints and writes what was found or loaded.
void show(studies::KeptFormFactors& kept, const FormFactorsCommand& command, OutputFolder* out) {
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    kept.warnings = reports::form_factor_warnings(report);
    for (const std::string& warning : kept.warnings) say("warning: {}\n", warning);
    // Before anything can fail that would lose it.
    if (!command.quiet) fmt::print("{}", reports::form_factors_text(report, style_of_stdout()));
    if (out != nullptr) write_files(*out, kept);
}

/// The folder to write to, if one is given, once it is certain that it can be.
std::unique_ptr<OutputFolder> open_folder(const FormFactorsCommand& command) {
    if (command.out.empty()) return nullptr;
    return std::make_unique<OutputFolder>(command.out, "matrix", files);
}

ExitCode exit_code_of(const studies::KeptFormFactors& kept) {
    const bool trusted = studies::is_trusted(kept.scene, kept.matrix, kept.request.tolerance);
    return kept.matrix.missed() == 0 && trusted ? ExitCode::passed : ExitCode::inconclusive;
}

ExitCode load(const FormFactorsCommand& command) {
    const bool is_folder = std::filesystem::is_directory(command.load);
    const auto file = is_folder ? command.load / store_file : command.load;
    studies::KeptFormFactors kept = studies::load_form_factors(file);
    if (!kept.was_checked) note_unchecked(file);
    kept.matrix.faults = studies::examine_scene(kept.scene).faults;
    if (command.request.repair && !kept.matrix.repaired) {
        studies::expect_repairable(kept.scene);
        kept.request.repair = true;
        kept.matrix.repaired = studies::repair(kept.matrix);
    }
    auto out = open_folder(command);
    show(kept, command, out.get());
    return exit_code_of(kept);
}

}  // namespace

studies::KeptFormFactors prepare_form_factors(const FormFactorsCommand& command) {
    studies::KeptFormFactors kept;
    kept.request = request_of(command);
    kept.source = read_source(command);
    kept.scene = make_scene(kept.source);
    return kept;
}

bool compute_form_factors(const FormFactorsCommand& command, studies::KeptFormFactors& kept) {
    std::optional<std::chrono::duration<double>> max_time;
    if (command.max_time) max_time = parse_duration(*command.max_time);
    studies::SceneDoubts doubts = studies::examine_scene(kept.scene);
    if (!command.quiet) {
        for (const std::string& note : doubts.notes) say("note: {}\n", note);
    }
    stop_in_order_on_signals();
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    std::optional<TimeLimit> limit(max_time);
    FormFactorDisplay display(kept.request.tolerance);
    if (!command.quiet && FormFactorDisplay::is_seen()) {
        kept.request.report = [&](const studies::FormFactorProgress& progress) { display.show(progress); };
    }
    kept.matrix = studies::find_form_factors(kept.scene, kept.request);
    kept.matrix.faults = std::move(doubts.faults);
    display.finish();
    limit.reset();
    kept.context = describe_run(in_words(command), kept.request.threads, seconds());
    return kept.matrix.interrupted && !(max_time && seconds() >= max_time->count());
}

ExitCode form_factors(const FormFactorsCommand& command) {
    if (!command.load.empty()) return load(command);
    auto kept = prepare_form_factors(command);
    const auto out = open_folder(command);
    const bool by_signal = compute_form_factors(command, kept);
    show(kept, command, out.get());
    return by_signal ? ExitCode::interrupted : exit_code_of(kept);
}

}  // namespace ff::app
