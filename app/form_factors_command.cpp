#include "app/commands.hpp"

#include "app/common_options.hpp"
#include "app/limits.hpp"
#include "app/messages.hpp"
#include "app/result_files.hpp"
#include "app/run_context.hpp"
#include "app/signals.hpp"

#include "core/error.hpp"
#include "core/mirrors.hpp"
#include "reports/form_factors.hpp"
#include "reports/json.hpp"
#include "reports/matrix_files.hpp"
#include "reports/output_file.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/text_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>

namespace ff::app {
namespace {

Scene read_scene(const std::string& name) {
    const bool is_file = studies::names_scene_file(name);
    Scene scene = studies::make_scene(
        is_file ? studies::with_scene_text(name, studies::read_text_file(studies::scene_file(name))) : name);
    if (mirrors(scene).empty()) return scene;
    throw UserError(fmt::format(
        "scene '{}': mirrors (pairs are computed one by one, which does not follow reflected light). Make it a study "
        "with estimator = \"ray_shooting\", or leave them out.",
        name));
}

void write_matrix(const std::filesystem::path& folder, const std::string& file, const Eigen::MatrixXd& matrix,
                  const std::string& comment) {
    reports::write_file(folder / (file + ".mtx"),
                        [&](std::ostream& out) { reports::write_sparse_matrix_market(out, matrix, comment); });
    reports::write_file(folder / (file + ".npy"), [&](std::ostream& out) { reports::write_npy(out, matrix); });
}

void write_files(const std::filesystem::path& folder, const reports::FormFactorReport& report,
                 const studies::Context& context) {
    make_folder(folder);
    const auto& [scene, request, matrix] = report;
    reports::write_file(folder / "matrix.csv",
                        [&](std::ostream& out) { reports::write_form_factors_csv(out, report); });
    write_matrix(folder, "form_factors", matrix.factors(), scene.name);
    write_matrix(folder, "half_widths", matrix.half_widths(), scene.name);
    write_matrix(folder, "areas",
                 Eigen::Map<const Eigen::VectorXd>(matrix.geometry.areas.data(),
                                                   static_cast<Eigen::Index>(matrix.geometry.areas.size())),
                 scene.name);
    if (matrix.repaired && matrix.repaired->possible)
        write_matrix(folder, "repaired", matrix.repaired->factors, scene.name);
    reports::write_file(folder / "form_factors.json", reports::form_factors_json(report));
    reports::write_file(folder / "context.json", reports::context_json(context));
}

}  // namespace

ExitCode form_factors(const FormFactorsCommand& command) {
    studies::FormFactorRequest request = command.request;
    request.seed = checked_seed(command.seed);
    request.threads = thread_count(command.threads);
    std::optional<std::chrono::duration<double>> max_time;
    if (command.max_time) max_time = parse_duration(*command.max_time);
    if (command.whole_matrix) request.level_of = studies::LevelOf::matrix;
    const Scene scene = read_scene(command.scene);
    if (!command.quiet) {
        for (const std::string& doubt : studies::doubts_about(scene)) say("note: {}\n", doubt);
    }
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    request.stop = &stop_on_signals();
    std::optional<TimeLimit> limit(max_time);
    const studies::FormFactorMatrix matrix = studies::find_form_factors(scene, request);
    limit.reset();
    end_on_signals();
    const bool out_of_time = max_time && seconds() >= max_time->count();
    const reports::FormFactorReport report{scene, request, matrix};
    for (const std::string& warning : reports::form_factor_warnings(report)) say("warning: {}\n", warning);
    // Before anything can fail that would lose it.
    if (!command.quiet) fmt::print("{}", reports::form_factors_text(report));
    if (!command.out.empty()) {
        const std::string words =
            fmt::format("ffstudy form_factors {} --tolerance {} --level {}{} --seed {}{}", command.scene,
                        request.tolerance, request.level, command.whole_matrix ? " --simultaneous" : "", command.seed,
                        request.repair ? " --repair" : "");
        write_files(command.out, report, describe_run(words, request.threads, seconds()));
    }
    if (matrix.interrupted && !out_of_time) return ExitCode::interrupted;
    return matrix.missed() == 0 ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace ff::app
