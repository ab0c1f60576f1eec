#include "app/commands.hpp"

#include "app/common_options.hpp"
#include "app/limits.hpp"
#include "app/messages.hpp"
#include "app/progress.hpp"
#include "app/result_files.hpp"
#include "app/run_context.hpp"
#include "app/signals.hpp"

#include "core/error.hpp"
#include "core/mirrors.hpp"
#include "reports/form_factors.hpp"
#include "reports/json.hpp"
#include "reports/matrix_files.hpp"
#include "reports/output_file.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/form_factors/store.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/text_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>

namespace ff::app {
namespace {

constexpr const char* store_file = "form_factors.sqlite";

/// A built-in name, or name and text of a file.
std::string read_source(const std::string& name) {
    if (name.empty()) throw UserError("SCENE is missing. See 'ffstudy form_factors --help'.");
    return studies::names_scene_file(name)
               ? studies::with_scene_text(name, studies::read_text_file(studies::scene_file(name)))
               : name;
}

Scene make_scene(const std::string& source) {
    Scene scene = studies::make_scene(source);
    if (mirrors(scene).empty()) return scene;
    throw UserError(fmt::format(
        "scene '{}': mirrors (pairs are computed one by one, which does not follow reflected light). Make it a study "
        "with estimator = \"ray_shooting\", or leave them out.",
        scene.name));
}

void write_matrix(const std::filesystem::path& folder, const std::string& file, const Eigen::MatrixXd& matrix,
                  const std::string& comment) {
    reports::write_file(folder / (file + ".mtx"),
                        [&](std::ostream& out) { reports::write_sparse_matrix_market(out, matrix, comment); });
    reports::write_file(folder / (file + ".npy"), [&](std::ostream& out) { reports::write_npy(out, matrix); });
}

void write_files(const std::filesystem::path& folder, const studies::KeptFormFactors& kept) {
    make_folder(folder);
    reports::replace_file(folder / store_file, [&](const auto& file) { studies::save_form_factors(file, kept); });
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    const auto& [scene, request, matrix] = report;
    reports::write_file(folder / "matrix.csv",
                        [&](std::ostream& out) { reports::write_form_factors_csv(out, report); });
    write_matrix(folder, "form_factors", matrix.factors(), scene.name);
    write_matrix(folder, "half_widths", matrix.half_widths(), scene.name);
    write_matrix(folder, "areas",
                 Eigen::Map<const Eigen::VectorXd>(matrix.areas.data(), static_cast<Eigen::Index>(matrix.areas.size())),
                 scene.name);
    if (matrix.repaired && matrix.repaired->possible)
        write_matrix(folder, "repaired", matrix.repaired->factors, scene.name);
    reports::write_file(folder / "form_factors.json", reports::form_factors_json(report));
    reports::write_file(folder / "context.json", reports::context_json(kept.context));
}

studies::FormFactorRequest request_of(const FormFactorsCommand& command) {
    studies::FormFactorRequest request = command.request;
    request.seed = checked_seed(command.seed);
    request.threads = thread_count(command.threads);
    if (command.whole_matrix) request.level_of = studies::LevelOf::matrix;
    request.stop = &stop_on_signals();
    return request;
}

std::string in_words(const FormFactorsCommand& command) {
    return fmt::format("ffstudy form_factors {} --tolerance {} --level {}{} --seed {}{}", command.scene,
                       command.request.tolerance, command.request.level, command.whole_matrix ? " --simultaneous" : "",
                       command.seed, command.request.repair ? " --repair" : "");
}

/// Prints and writes what was found or loaded.
void show(studies::KeptFormFactors& kept, const FormFactorsCommand& command) {
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    kept.warnings = reports::form_factor_warnings(report);
    for (const std::string& warning : kept.warnings) say("warning: {}\n", warning);
    // Before anything can fail that would lose it.
    if (!command.quiet) fmt::print("{}", reports::form_factors_text(report));
    if (!command.out.empty()) write_files(command.out, kept);
}

ExitCode load(const FormFactorsCommand& command) {
    const bool is_folder = std::filesystem::is_directory(command.load);
    studies::KeptFormFactors kept = studies::load_form_factors(is_folder ? command.load / store_file : command.load);
    if (command.request.repair && !kept.matrix.repaired) {
        studies::expect_repairable(kept.scene);
        kept.request.repair = true;
        kept.matrix.repaired = studies::repair(kept.matrix);
    }
    show(kept, command);
    return kept.matrix.missed() == 0 ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace

ExitCode form_factors(const FormFactorsCommand& command) {
    if (!command.load.empty()) return load(command);
    studies::KeptFormFactors kept;
    kept.request = request_of(command);
    std::optional<std::chrono::duration<double>> max_time;
    if (command.max_time) max_time = parse_duration(*command.max_time);
    kept.source = read_source(command.scene);
    kept.scene = make_scene(kept.source);
    if (!command.quiet) {
        for (const std::string& doubt : studies::doubts_about(kept.scene)) say("note: {}\n", doubt);
    }
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    std::optional<TimeLimit> limit(max_time);
    FormFactorDisplay display(kept.request.tolerance);
    if (!command.quiet && display.is_seen()) {
        kept.request.report = [&](const studies::FormFactorProgress& progress) { display.show(progress); };
    }
    kept.matrix = studies::find_form_factors(kept.scene, kept.request);
    display.finish();
    limit.reset();
    const bool out_of_time = max_time && seconds() >= max_time->count();
    kept.context = describe_run(in_words(command), kept.request.threads, seconds());
    show(kept, command);
    if (kept.matrix.interrupted && !out_of_time) return ExitCode::interrupted;
    return kept.matrix.missed() == 0 ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace ff::app
