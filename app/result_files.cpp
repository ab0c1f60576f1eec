#include "app/result_files.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "reports/audit_markdown.hpp"
#include "reports/csv.hpp"
#include "reports/html.hpp"
#include "reports/json.hpp"
#include "reports/markdown.hpp"
#include "reports/output_file.hpp"

#include <fmt/format.h>

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

void write_csv(const std::filesystem::path& folder, const ResultSources& sources) {
    reports::write_file(folder / "summary.csv",
                        [&](std::ostream& out) { reports::write_summary_csv(out, sources.results.findings); });
    reports::write_file(folder / "slopes.csv",
                        [&](std::ostream& out) { reports::write_slopes_csv(out, sources.results); });
    if (!sources.results.findings.plan.spec.coverage.empty()) {
        reports::write_file(folder / "coverage.csv",
                            [&](std::ostream& out) { reports::write_coverage_csv(out, sources.results); });
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

constexpr std::array<std::string_view, 4> names{"html", "markdown", "csv", "json"};
constexpr std::array<std::string_view, 8> files{"report.html", "report.md",  "audit.md",     "summary.csv",
                                                "slopes.csv",  "trials.csv", "results.json", "context.json"};
constexpr std::array writers{write_html, write_markdown, write_csv, write_json};

}  // namespace

std::span<const std::string_view> all_formats() {
    return names;
}

void expect_room_for_results(const std::filesystem::path& folder) {
    for (const std::string_view file : files) {
        if (std::filesystem::is_directory(folder / file)) {
            throw IoError(
                fmt::format("{}: cannot be written (a folder is in the way). Remove it, or choose another --out.",
                            (folder / file).string()));
        }
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw IoError(fmt::format("{}: cannot be made ({}). Choose another --out.", folder.string(), error.message()));
}

void write_results(const std::filesystem::path& folder, const ResultSources& sources,
                   std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) {
        const auto found = std::find(names.begin(), names.end(), format);
        if (found == names.end()) {
            throw UserError(fmt::format("--format {} is unknown. {}Known: {}.", format, did_you_mean(format, names),
                                        fmt::join(names, ", ")));
        }
    }
    for (const std::string_view format : formats) {
        writers.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), format) - names.begin()))(folder,
                                                                                                            sources);
    }
}

}  // namespace ff::app
