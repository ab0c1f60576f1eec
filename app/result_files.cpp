#include "app/result_files.hpp"

#include "app/messages.hpp"
#include "app/picture_files.hpp"
#include "app/signals.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "reports/audit_markdown.hpp"
#include "reports/csv.hpp"
#include "reports/csv_radiosity.hpp"
#include "reports/html.hpp"
#include "reports/json.hpp"
#include "reports/latex.hpp"
#include "reports/markdown.hpp"
#include "reports/matrix_files.hpp"
#include "reports/output_file.hpp"
#include "studies/interruptible_evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ff::app {
namespace {

void write_markdown(const std::filesystem::path& folder, const ResultSources& sources) {
    const studies::StudyResults& results = sources.results;
    reports::write_file(folder / "report.md", reports::markdown_report(results));
    if (!results.published) return;
    reports::write_file(folder / "audit.md",
                        reports::audit_markdown(results.published->tables, results.published->audit));
}

struct RadiosityTable {
    std::string_view file;
    void (*write)(std::ostream& out, const studies::StudyResults& results);
};
constexpr std::array tables_of_radiosity{RadiosityTable{"matrices.csv", reports::write_matrices_csv},
                                         RadiosityTable{"systems.csv", reports::write_systems_csv},
                                         RadiosityTable{"exitance.csv", reports::write_exitance_csv},
                                         RadiosityTable{"solvers.csv", reports::write_solvers_csv},
                                         RadiosityTable{"residuals.csv", reports::write_residuals_csv}};

void write_csv(const std::filesystem::path& folder, const ResultSources& sources) {
    reports::write_file(folder / "summary.csv",
                        [&](std::ostream& out) { reports::write_summary_csv(out, sources.results.findings); });
    reports::write_file(folder / "slopes.csv",
                        [&](std::ostream& out) { reports::write_slopes_csv(out, sources.results); });
    if (!sources.results.findings.plan.spec.coverage.empty()) {
        reports::write_file(folder / "coverage.csv",
                            [&](std::ostream& out) { reports::write_coverage_csv(out, sources.results); });
    }
    if (sources.results.radiosity) {
        for (const RadiosityTable& table : tables_of_radiosity)
            reports::write_file(folder / table.file, [&](std::ostream& out) { table.write(out, sources.results); });
    }
    reports::write_file(folder / "trials.csv",
                        [&](std::ostream& out) { reports::write_trials_csv(out, sources.store); });
}

void write_json(const std::filesystem::path& folder, const ResultSources& sources) {
    reports::write_file(folder / "results.json", reports::results_json(sources.results));
    reports::write_file(folder / "context.json", reports::context_json(sources.results.context));
}

void write_html(const std::filesystem::path& folder, const ResultSources& sources) {
    reports::write_file(folder / "report.html", reports::html_report(sources.results, sources.templates));
}

void write_latex(const std::filesystem::path& folder, const ResultSources& sources) {
    make_folder(folder / "tables");
    for (const auto& [path, text] : reports::latex_report(sources.results, sources.templates))
        reports::write_file(folder / path, text);
}

void write_matrices(const std::filesystem::path& folder, const ResultSources& sources) {
    for (const auto& [path, text] : reports::matrix_files(sources.store)) {
        const auto file = folder / "matrices" / path;
        make_folder(file.parent_path());
        reports::write_file(file, text);
    }
}

void write_patch_systems(const std::filesystem::path& folder, const ResultSources& sources) {
    reports::patch_systems(
        sources.store, [&](const std::string& path, const Eigen::MatrixXd& matrix, const std::string& comment) {
            const auto file = folder / "matrices" / path;
            make_folder(file.parent_path());
            reports::write_file(file.string() + ".mtx",
                                [&](std::ostream& out) { reports::write_matrix_market(out, matrix, comment); });
            reports::write_file(file.string() + ".npy", [&](std::ostream& out) { reports::write_npy(out, matrix); });
        });
}

void needs_nothing() {}

struct KnownFormat {
    Format format;
    void (*expect_programs)();
    void (*write)(const std::filesystem::path& folder, const ResultSources& sources);
};

constexpr std::array known{
    KnownFormat{{"html", "report.html"}, needs_nothing, write_html},
    KnownFormat{{"markdown", "report.md, audit.md"}, needs_nothing, write_markdown},
    KnownFormat{{"csv", "summary.csv, slopes.csv, coverage.csv, trials.csv"}, needs_nothing, write_csv},
    KnownFormat{{"json", "results.json, context.json"}, needs_nothing, write_json},
    KnownFormat{{"matrices", "matrices/*/*.mtx, matrices/*/*.npy"}, needs_nothing, write_matrices},
    KnownFormat{{"patch_systems", "matrices/*/patch_*"}, needs_nothing, write_patch_systems},
    KnownFormat{{"latex", "tables.tex, tables/*.tex"}, needs_nothing, write_latex},
    KnownFormat{{"svg", "pictures/*.svg"}, expect_svg_programs, write_svg},
    KnownFormat{{"pdf", "pictures/*.pdf"}, expect_pdf_programs, write_pdf},
};
constexpr std::array<std::string_view, 4> of_a_run{"html", "markdown", "csv", "json"};

/// Every file that the usual formats may write, in this folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const char* name : {"report.html", "report.md", "audit.md", "summary.csv", "slopes.csv", "coverage.csv",
                             "trials.csv", "results.json", "context.json"})
        files.push_back(folder / name);
    for (const RadiosityTable& table : tables_of_radiosity) files.push_back(folder / table.file);
    return files;
}

const KnownFormat& find_format(std::string_view name) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.format.name == name; });
    if (found != known.end()) return *found;
    std::vector<std::string_view> names;
    for (const KnownFormat& each : known) names.push_back(each.format.name);
    throw UserError(
        fmt::format("--format {} is unknown. {}Known: {}.", name, did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace

std::vector<Format> all_formats() {
    std::vector<Format> formats;
    for (const KnownFormat& each : known) formats.push_back(each.format);
    return formats;
}

std::span<const std::string_view> usual_formats() {
    return of_a_run;
}

void expect_formats(std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) find_format(format).expect_programs();
}

std::filesystem::path store_of(const std::filesystem::path& results) {
    return std::filesystem::is_directory(results) ? results / "results.sqlite" : results;
}

void expect_room_for_results(const std::filesystem::path& folder) {
    for (const auto& file : files_in(folder)) {
        if (std::filesystem::is_directory(file)) {
            throw IoError(fmt::format(
                "{}: cannot be written (a folder is in the way). Remove it, or choose another --out.", file.string()));
        }
    }
}

void remove_results(const std::filesystem::path& folder) {
    for (const auto& file : files_in(folder)) {
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error) throw IoError(fmt::format("{}: cannot be removed ({}).", file.string(), error.message()));
    }
}

void seal(studies::Store& store, bool quiet) {
    if (store.seal() || quiet) return;
    say("note: another program has results.sqlite open, so results.sqlite-wal is a part of it until ffstudy is run on "
        "the folder again.\n");
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw IoError(fmt::format("{}: cannot be made ({}). Choose another --out.", folder.string(), error.message()));
}

Evaluated evaluate_until_stopped(const studies::Store& store) {
    const studies::StudyPlan& plan = store.plan();
    if (!plan.spec.radiosity || plan.spec.radiosity->patch_trials == 0) {
        end_on_signals();
        return {studies::evaluate(store)};
    }
    Evaluated evaluated{studies::evaluate(store, stop_on_signals())};
    end_on_signals();
    if (!evaluated.results.radiosity) return evaluated;
    const auto trials = studies::patch_trials(plan, *evaluated.results.radiosity);
    evaluated.to_the_end = trials.complete();
    if (!evaluated.to_the_end) {
        say("stopped with {} of {} trials put into systems between patches. All trials are saved: 'ffstudy report' on "
            "the folder does the rest.\n",
            trials.done, trials.wanted);
    }
    return evaluated;
}

void write_results(const std::filesystem::path& folder, const ResultSources& sources,
                   std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) find_format(format).write(folder, sources);
}

}  // namespace ff::app
