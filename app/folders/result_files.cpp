#include "app/folders/result_files.hpp"

#include "app/folders/picture_files.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/points/stream.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "reports/csv/csv.hpp"
#include "reports/files/array_files.hpp"
#include "reports/files/matrix_files.hpp"
#include "reports/html/html.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/json.hpp"
#include "reports/latex/latex.hpp"
#include "reports/markdown/audit_markdown.hpp"
#include "reports/markdown/markdown.hpp"
#include "reports/pictures/answer_svg.hpp"
#include "reports/pictures/drawing_request.hpp"
#include "reports/text/numbers.hpp"
#include "studies/radiosity/cost.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::app {
namespace {

/// Writes the picture, or removes that of an earlier run where there is none.
void write_picture(OutputFolder& folder, const std::string& file, const std::optional<std::string>& svg) {
    if (svg)
        folder.write(file, *svg);
    else
        folder.remove(file);
}

void write_markdown(OutputFolder& folder, const ResultSources& sources) {
    const studies::StudyResults& results = sources.results;
    folder.write("report.md", reports::markdown_report(results));
    const auto lead = reports::answer_picture(results);
    write_picture(folder, "answer.svg", lead ? std::optional(reports::answer_svg(*lead)) : std::nullopt);
    write_picture(folder, "decisions_by_time.svg", reports::decisions_svg(results));
    if (!results.published) return;
    folder.write("audit.md", reports::audit_markdown(results.published->tables, results.published->audit));
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

void write_csv(OutputFolder& folder, const ResultSources& sources) {
    folder.write("summary.csv", [&](std::ostream& out) { reports::write_summary_csv(out, sources.results.findings); });
    folder.write("slopes.csv", [&](std::ostream& out) { reports::write_slopes_csv(out, sources.results); });
    folder.write("comparisons.csv",
                 [&](std::ostream& out) { reports::write_comparisons_csv(out, sources.results, reports::Timed::no); });
    folder.write("comparisons_by_time.csv",
                 [&](std::ostream& out) { reports::write_comparisons_csv(out, sources.results, reports::Timed::yes); });
    folder.write("claimed_errors.csv",
                 [&](std::ostream& out) { reports::write_claimed_errors_csv(out, sources.results); });
    if (!sources.results.findings.plan.spec.coverage.empty()) {
        folder.write("coverage.csv", [&](std::ostream& out) { reports::write_coverage_csv(out, sources.results); });
    }
    if (sources.results.radiosity) {
        for (const RadiosityTable& table : tables_of_radiosity)
            folder.write(std::string(table.file), [&](std::ostream& out) { table.write(out, sources.results); });
    }
    folder.write("trials.csv", [&](std::ostream& out) { reports::write_trials_csv(out, sources.store); });
}

void write_json(OutputFolder& folder, const ResultSources& sources) {
    folder.write("results.json", reports::results_json(sources.results));
    folder.write("context.json", reports::context_json(sources.results.context));
}

void write_html(OutputFolder& folder, const ResultSources& sources) {
    folder.write("report.html", reports::html_report(sources.results, sources.templates));
}

/// Contents by name: all of them, or none where one may not be written.
template <class Files>
void write_all(OutputFolder& folder, const std::string& prefix, const Files& files) {
    std::vector<std::string> names;
    for (const auto& [name, text] : files) names.push_back(prefix + name);
    folder.expect_own(names);
    for (const auto& [name, text] : files) folder.write(prefix + name, text);
}

void write_latex(OutputFolder& folder, const ResultSources& sources) {
    write_all(folder, "", reports::latex_report(sources.results, sources.templates));
}

void write_matrices(OutputFolder& folder, const ResultSources& sources) {
    write_all(folder, "matrices/", reports::matrix_files(sources.store));
}

void write_patch_systems(OutputFolder& folder, const ResultSources& sources) {
    reports::patch_systems(
        sources.store, [&](const std::string& path, const Eigen::MatrixXd& matrix, const std::string& comment) {
            folder.write("matrices/" + path + ".mtx",
                         [&](std::ostream& out) { reports::write_matrix_market(out, matrix, comment); });
            folder.write("matrices/" + path + ".npy", [&](std::ostream& out) { reports::write_npy(out, matrix); });
        });
}

void needs_nothing() {}

struct KnownFormat {
    Format format;
    void (*expect_programs)();
    void (*write)(OutputFolder& folder, const ResultSources& sources);
};

constexpr std::array known_formats{
    KnownFormat{{"html", "report.html"}, needs_nothing, write_html},
    KnownFormat{{"markdown", "report.md, answer.svg, audit.md"}, needs_nothing, write_markdown},
    KnownFormat{{"csv", "summary.csv, slopes.csv, comparisons.csv, ..., trials.csv"}, needs_nothing, write_csv},
    KnownFormat{{"json", "results.json, context.json"}, needs_nothing, write_json},
    KnownFormat{{"matrices", "matrices/*/*.mtx, matrices/*/*.npy"}, needs_nothing, write_matrices},
    KnownFormat{{"patch_systems", "matrices/*/patch_*"}, needs_nothing, write_patch_systems},
    KnownFormat{{"latex", "tables.tex, tables/*.tex"}, needs_nothing, write_latex},
    KnownFormat{{"svg", "pictures/*.svg"}, expect_svg_programs, write_svg},
    KnownFormat{{"pdf", "pictures/*.pdf"}, expect_pdf_programs, write_pdf},
};

constexpr const char* evaluated_again =
    "\nstopped while results were evaluated or written. What was found is saved: run the same command again to "
    "resume.\n";

const KnownFormat& find_format(std::string_view name) {
    const auto found =
        std::find_if(known_formats.begin(), known_formats.end(), [&](const auto& k) { return k.format.name == name; });
    if (found != known_formats.end()) return *found;
    std::vector<std::string_view> names;
    for (const KnownFormat& each : known_formats) names.push_back(each.format.name);
    throw UserError("--format {} is unknown. {}Known: {}.", name, did_you_mean(name, names), fmt::join(names, ", "));
}

}  // namespace

std::vector<Format> all_formats() {
    std::vector<Format> formats;
    for (const KnownFormat& each : known_formats) formats.push_back(each.format);
    return formats;
}

void expect_formats(std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) find_format(format).expect_programs();
}

std::vector<reports::Picture> chosen_pictures(const studies::StudyResults& results,
                                              const std::vector<std::string>& names) {
    auto pictures = reports::all_pictures(results);
    const auto is_of = [](const reports::Picture& picture, const std::string& name) {
        return picture.id == name || picture.id.starts_with(name + "-");
    };
    for (const std::string& name : names) {
        if (std::none_of(pictures.begin(), pictures.end(), [&](const auto& picture) { return is_of(picture, name); }))
            throw UserError(
                "--pictures {} (no picture has a name that begins so). 'ffstudy figure RESULTS' lists them.", name);
    }
    if (names.empty()) return pictures;
    std::erase_if(pictures, [&](const reports::Picture& picture) {
        return std::none_of(names.begin(), names.end(), [&](const auto& name) { return is_of(picture, name); });
    });
    return pictures;
}

bool is_folder_of_study(const std::filesystem::path& study) {
    std::error_code error;
    return std::filesystem::is_directory(study, error) && std::filesystem::is_regular_file(store_of(study), error);
}

std::filesystem::path store_of(const std::filesystem::path& results) {
    return std::filesystem::is_directory(results) ? results / "results.sqlite" : results;
}

studies::Store open_results(const std::filesystem::path& results) {
    const auto file = store_of(results);
    auto store = studies::Store::open(file);
    if (!store.was_checked()) note_unchecked(file);
    return store;
}

std::vector<std::string> usual_files() {
    std::vector<std::string> files{"report.html",
                                   "report.md",
                                   "answer.svg",
                                   "decisions_by_time.svg",
                                   "audit.md",
                                   "summary.csv",
                                   "slopes.csv",
                                   "coverage.csv",
                                   "trials.csv",
                                   "results.json",
                                   "comparisons.csv",
                                   "context.json",
                                   "comparisons_by_time.csv",
                                   "claimed_errors.csv"};
    for (const RadiosityTable& table : tables_of_radiosity) files.emplace_back(table.file);
    return files;
}

std::string owner_of(const studies::StudySpec& spec) {
    const StreamKey key = derive_key(Seed{0}, to_toml(spec) + (spec.published ? spec.published->text : ""));
    return fmt::format("study {:08x}{:08x}", key.word0, key.word1);
}

studies::Store open_or_create(OutputFolder& out, const studies::StudyPlan& plan) {
    const auto file = out.path() / "results.sqlite";
    const auto files = usual_files();
    if (!std::filesystem::exists(file)) out.expect_own(files);
    auto store = studies::Store::create_or_resume(file, plan);
    if (!store.was_checked()) note_unchecked(file);
    // The store belongs to this study, and so do the reports that were made from it.
    out.inherit("study ");
    out.expect_own(files);
    return store;
}

void note_unchecked(const std::filesystem::path& file) {
    say("note: {}: written by an earlier version of ffstudy, without checksums. Damage to it may go unnoticed.\n",
        file.string());
}

void seal(studies::Store& store, bool quiet) {
    if (store.seal() || quiet) return;
    say("note: another program has results.sqlite open, so results.sqlite-wal is a part of it until ffstudy is run on "
        "the folder again.\n");
}

Evaluated evaluate_until_stopped(const studies::Store& store, bool quiet) {
    const studies::StudyPlan& plan = store.plan();
    if (!plan.spec.radiosity || plan.spec.radiosity->patch_trials == 0) {
        end_on_signals(evaluated_again);
        return {studies::evaluate(store)};
    }
    stop_gracefully_on_signals();
    constexpr double worth_a_note = 3;
    const double seconds = studies::radiosity::seconds_needed(plan);
    if (!quiet && (seconds > worth_a_note || is_verbose()))
        say("Solving the systems between patches takes about {} on one core; Ctrl-C leaves out the rest.\n",
            reports::seconds_in_words(seconds));
    Evaluated evaluated{studies::evaluate(store, &stop_flag())};
    end_on_signals(evaluated_again);
    if (!evaluated.results.radiosity) return evaluated;
    const auto trials = studies::radiosity::patch_trials(plan, *evaluated.results.radiosity);
    evaluated.to_the_end = trials.complete();
    if (!evaluated.to_the_end) {
        say("stopped with {} of {} trials put into systems between patches. All trials are saved: 'ffstudy report' on "
            "the folder does the rest.\n",
            trials.done, trials.wanted);
    }
    return evaluated;
}

void write_results(OutputFolder& folder, const ResultSources& sources, std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) find_format(format).write(folder, sources);
}

}  // namespace ff::app
