#include "app/commands/form_factors/form_factor_run.hpp"

#include "app/command_line/common_options.hpp"
#include "app/commands/context/run_context.hpp"
#include "app/commands/form_factors/form_factor_rows.hpp"
#include "app/folders/output_folder.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/process/limits.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"
#include "app/terminal/progress.hpp"

#include "core/support/error.hpp"
#include "reports/csv/scene_csv.hpp"
#include "reports/files/array_files.hpp"
#include "reports/html/scene_html.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/form_factors_json.hpp"
#include "reports/programs/hand_over.hpp"
#include "reports/terminal/scene_terminal.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/scene_reports.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/store/store.hpp"
#include "studies/heat/materials.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::app {
namespace {

const std::vector<std::string> matrix_files{
    matrix_store_file,  "matrix.csv",         "form_factors.mtx", "form_factors.npy",
    "form_factors.npz", "half_widths.mtx",    "half_widths.npy",  "half_widths.npz",
    "areas.mtx",        "areas.npy",          "repaired.mtx",     "repaired.npy",
    "repaired.npz",     "form_factors.json",  "intervals.csv",    "context.json",
    "report.html",      "randomisations.npz", rows_file};

/// Files for a matrix, whose sizes decide which are written.
class MatrixFiles {
  public:
    MatrixFiles(OutputFolder& folder, const studies::form_factors::KeptMatrix& kept, bool text)
        : folder_(folder),
          scene_(kept.scene.name),
          is_small_(kept.matrix.faces() <= studies::form_factors::most_dense_faces),
          has_text_(text || is_small_) {}

    [[nodiscard]] bool has_text() const { return has_text_; }

    void write(const std::string& file, const studies::form_factors::Matrix::Sparse& matrix) const {
        folder_.write(file + ".npz", [&](std::ostream& out) { reports::write_sparse_npz(out, matrix); });
        if (has_text_) write_text(file, matrix);
        if (is_small_) write_npy(file, Eigen::MatrixXd(matrix), 2);
    }

    void write_areas(const std::vector<double>& areas) const {
        const Eigen::MatrixXd column =
            Eigen::Map<const Eigen::VectorXd>(areas.data(), static_cast<Eigen::Index>(areas.size()));
        write_text("areas", column.sparseView());
        write_npy("areas", column, 1);
    }

  private:
    OutputFolder& folder_;
    const std::string& scene_;
    bool is_small_;
    bool has_text_;

    void write_text(const std::string& file, const Eigen::SparseMatrix<double>& matrix) const {
        folder_.write(file + ".mtx",
                      [&](std::ostream& out) { reports::write_sparse_matrix_market(out, matrix, scene_); });
    }

    void write_npy(const std::string& file, const Eigen::MatrixXd& matrix, int dimensions) const {
        folder_.write(file + ".npy", [&](std::ostream& out) { reports::write_npy(out, matrix, dimensions); });
    }
};

/// Writes files for other programs, and the intervals of the values in them.
void hand_on_files(OutputFolder& folder, const studies::form_factors::KeptMatrix& kept,
                   const std::vector<std::string>& formats) {
    if (formats.empty()) return;
    const auto handed = reports::hand_on(kept.scene, kept.matrix,
                                         studies::heat::said_emissivities(kept.source, kept.scene.faces.size()));
    // View3D's file has an emissivity for each face, which is 1 of all where the scene gives none.
    const bool some_are_known =
        std::ranges::any_of(handed.emissivities, [](const auto& emissivity) { return emissivity.has_value(); });
    if (some_are_known && std::ranges::find(formats, "view3d") != formats.end())
        note_unknown_emissivities(handed.emissivities, "1 in view3d.txt");
    for (const reports::ProgramFile& file : reports::files_of_formats(formats, kept.scene))
        folder.write(std::string(file.name), [&](std::ostream& out) { file.write(out, handed); });
    folder.write("intervals.csv", [&](std::ostream& out) { reports::write_intervals(out, handed); });
}

void write_matrix_files(OutputFolder& folder, const studies::form_factors::KeptMatrix& kept, bool text) {
    folder.replace(matrix_store_file, [&](const auto& file) { studies::form_factors::save_matrix(file, kept); });
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    const studies::form_factors::Matrix& matrix = kept.matrix;
    const MatrixFiles files(folder, kept, text);
    if (files.has_text())
        folder.write("matrix.csv", [&](std::ostream& out) { reports::write_form_factors_csv(out, report); });
    files.write("form_factors", matrix.factors());
    files.write("half_widths", matrix.half_widths());
    files.write_areas(matrix.areas);
    if (matrix.repaired && matrix.repaired->possible) files.write("repaired", matrix.repaired->factors);
    if (!matrix.randomisations.empty())
        folder.write("randomisations.npz", [&](std::ostream& out) { reports::write_randomisations(out, matrix); });
    folder.write("form_factors.json", reports::form_factors_json(report));
    folder.write("context.json", reports::context_json(kept.context));
    folder.write("report.html", reports::scene_html(report, kept.warnings, nullptr,
                                                    reports::program_label(kept.context), find_templates({})));
}

studies::form_factors::Request request_of(const FormFactorsCommand& command) {
    studies::form_factors::Request request = command.request;
    request.seed = checked_seed(command.seed);
    request.threads = thread_count(command.threads);
    if (command.whole_matrix) request.level_of = studies::form_factors::LevelOf::matrix;
    request.stop = &stop_flag();
    return request;
}

std::string in_words(const FormFactorsCommand& command) {
    std::string text = fmt::format("ffstudy form-factors {}", command.scene);
    for (const std::string& option : said_of_mesh(command)) text += " --" + option;
    if (!command.zone.empty()) text += fmt::format(" --zone '{}'", command.zone);
    text += fmt::format(" --tolerance {}", command.request.tolerance);
    if (command.request.relative > 0) text += fmt::format(" --relative {}", command.request.relative);
    if (command.request.drop > 0) text += fmt::format(" --drop {}", command.request.drop);
    if (!command.request.surroundings.empty()) text += fmt::format(" --surroundings {}", command.request.surroundings);
    text += fmt::format(" --level {}{} --seed {}", command.request.level, command.whole_matrix ? " --simultaneous" : "",
                        command.seed);
    return text + (command.request.repair ? " --repair" : "");
}

/// Prints and writes what was found or loaded.
void show(studies::form_factors::KeptMatrix& kept, const FormFactorsCommand& command, OutputFolder* out) {
    const reports::FormFactorReport report{kept.scene, kept.request, kept.matrix};
    kept.warnings = reports::form_factor_warnings(report);
    for (const std::string& warning : kept.warnings) say("warning: {}\n", warning);
    // Done before any failure could lose it.
    if (!command.quiet) print_folded(reports::form_factors_text(report, style_of_stdout()));
    if (out == nullptr) return;
    write_matrix_files(*out, kept, command.text);
    hand_on_files(*out, kept, command.formats);
}

/// The folder to write to, if one is given, after checking that it can be written.
std::unique_ptr<OutputFolder> open_matrix_folder(const FormFactorsCommand& command, const Scene& scene) {
    std::vector<std::string> names = matrix_files;
    for (const reports::ProgramFile& file : reports::files_of_formats(command.formats, scene))
        names.emplace_back(file.name);
    if (command.out.empty()) return nullptr;
    return std::make_unique<OutputFolder>(command.out, "matrix", names);
}

ExitCode exit_code_of(const studies::form_factors::KeptMatrix& kept) {
    const bool trusted = studies::form_factors::is_trusted(kept.scene, kept.matrix, kept.request.tolerance);
    return kept.matrix.missed() == 0 && trusted ? ExitCode::passed : ExitCode::inconclusive;
}

ExitCode load(const FormFactorsCommand& command) {
    studies::form_factors::KeptMatrix kept = load_kept_form_factors(command);
    if (command.request.repair) expect_nothing_dropped(kept, "--repair");
    if (!command.formats.empty()) expect_nothing_dropped(kept, "--format");
    if (command.request.repair && !kept.matrix.repaired) {
        studies::form_factors::expect_repairable(kept.scene);
        kept.request.repair = true;
        kept.matrix.repaired = studies::form_factors::repair(kept.matrix);
    }
    auto out = open_matrix_folder(command, kept.scene);
    show(kept, command, out.get());
    return exit_code_of(kept);
}

}  // namespace

void note_unknown_emissivities(const std::vector<std::optional<double>>& emissivities, std::string_view instead) {
    const auto unknown = std::count(emissivities.begin(), emissivities.end(), std::nullopt);
    if (unknown > 0)
        say("note: {} no single emissivity in the scene and {} {}.\n",
            unknown == 1 ? "1 face has" : fmt::format("{} faces have", unknown), unknown == 1 ? "gets" : "get",
            instead);
}

studies::form_factors::KeptMatrix prepare_form_factors(const FormFactorsCommand& command) {
    studies::form_factors::KeptMatrix kept;
    kept.request = request_of(command);
    kept.source = read_source(command);
    kept.scene = scene_without_mirrors(kept.source);
    return kept;
}

studies::form_factors::KeptMatrix load_kept_form_factors(const FormFactorsCommand& command) {
    const bool is_folder = std::filesystem::is_directory(command.load);
    const auto file = is_folder ? command.load / matrix_store_file : command.load;
    studies::form_factors::KeptMatrix kept = studies::form_factors::load_matrix(file);
    if (!kept.was_checked) note_unchecked(file);
    kept.matrix.faults = studies::examine_scene(studies::make_scene(kept.source)).faults;
    return kept;
}

void expect_nothing_dropped(const studies::form_factors::KeptMatrix& kept, std::string_view what) {
    if (kept.request.drop == 0) return;
    throw UserError("{}: the matrix was made with --drop {} ({} needs all pairs). Make it without.", what,
                    kept.request.drop, what);
}

bool compute_form_factors(const FormFactorsCommand& command, studies::form_factors::KeptMatrix& kept,
                          const FindFormFactors& find) {
    const auto max_time = parse_duration(command.max_time);
    const auto max_memory = parse_size(command.max_memory);
    studies::SceneDoubts doubts = studies::examine_scene(kept.scene);
    if (!command.quiet) {
        for (const std::string& note : doubts.notes) say("note: {}\n", note);
    }
    stop_gracefully_on_signals();
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    std::optional<Limits> limits(std::in_place, max_time, max_memory);
    ProgressDisplay display(command.quiet);
    if (display.is_bar()) {
        kept.request.report = [&](const studies::form_factors::Progress& progress) {
            display.show(progress, kept.request.tolerance);
        };
    }
    kept.matrix = find(kept.scene, kept.request);
    if (kept.matrix.faces() > kept.scene.faces.size())
        kept.scene = studies::form_factors::with_added_faces(std::move(kept.scene), kept.request.surroundings);
    kept.matrix.faults = std::move(doubts.faults);
    display.finish();
    limits.reset();
    kept.context = describe_run(in_words(command), kept.request.threads, seconds());
    return kept.matrix.interrupted && !(max_time && seconds() >= max_time->count());
}

ExitCode form_factors(const FormFactorsCommand& command) {
    if (!command.load.empty()) return load(command);
    if (!command.from.empty()) return sensor_factors(command);
    const Processes processes;
    auto kept = prepare_form_factors(command);
    kept.request.shard = rows_to_sample(command, processes);
    if (!processes.leads()) return assist_form_factors(processes, command, kept);
    if (command.dry_run) return predict_form_factors(kept);
    const auto out =
        open_matrix_folder(command, studies::form_factors::with_added_faces(kept.scene, kept.request.surroundings));
    RowsInFolder rows(out.get(), kept, processes);
    if (rows.count() > 0 && !command.quiet)
        say("note: resuming; {} sampled before.\n", reports::counted(rows.count(), "row"));
    const bool by_signal = compute_form_factors(command, kept);
    const bool is_whole = kept.matrix.left_out == 0 && rows.count() > 0;
    if (command.shard && !is_whole && !kept.matrix.interrupted) {
        rows.leave();
        if (!command.quiet)
            print_folded("shard {} is complete: {}\nWhen all are: ffstudy merge FOLDER... --out FOLDER\n",
                         *command.shard, (out->path() / rows_file).string());
        return ExitCode::passed;
    }
    if (kept.matrix.left_out == 0) rows.remove();
    show(kept, command, out.get());
    if (kept.matrix.left_out > 0 && rows.count() > 0)
        say("stopped early; rows that were sampled are kept. Run the same command again to resume.\n");
    return by_signal ? ExitCode::interrupted : exit_code_of(kept);
}

ExitCode merge_form_factors(const MergeCommand& command) {
    studies::form_factors::KeptMatrix kept;
    FormFactorsCommand as_asked;
    std::tie(kept.source, kept.request) =
        studies::form_factors::matrix_of_kept_rows(rows_of(command.sources.front()).value());
    kept.scene = scene_without_mirrors(kept.source);
    kept.request.threads = thread_count(std::nullopt);
    kept.request.finished.assign(kept.scene.faces.size(), true);  // nothing is sampled here
    kept.request.stop = &stop_flag();
    kept.request.randomisations = command.randomisations;
    as_asked.request = kept.request;
    as_asked.scene = kept.source.title();
    as_asked.seed = kept.request.seed.value;
    as_asked.whole_matrix = kept.request.level_of == studies::form_factors::LevelOf::matrix;
    as_asked.quiet = command.quiet;
    as_asked.out = command.out;
    for (const auto& source : command.sources) {
        std::error_code missing;
        if (!std::filesystem::equivalent(rows_of(source).value_or(source), command.out / rows_file, missing)) continue;
        throw UserError("--out {}: one of the shards lies there. Choose another folder.", command.out.string());
    }
    const auto out = open_matrix_folder(as_asked, kept.scene);
    const Processes processes;
    RowsInFolder rows(out.get(), kept, processes);
    for (const auto& source : command.sources) rows.take(rows_of(source).value_or(source));
    if (compute_form_factors(as_asked, kept)) return ExitCode::interrupted;
    if (kept.matrix.left_out > 0) {
        const std::size_t missing = kept.matrix.left_out;
        say("{} of the matrix {} missing. Merge again with the shards that hold {}, or run the command of the shards "
            "without --shard and with --out {}.\n",
            reports::counted(missing, "row"), missing == 1 ? "is" : "are", missing == 1 ? "it" : "them",
            command.out.string());
        return ExitCode::inconclusive;
    }
    rows.remove();
    show(kept, as_asked, out.get());
    return exit_code_of(kept);
}

}  // namespace ff::app
