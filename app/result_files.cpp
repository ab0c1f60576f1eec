#include "app/result_files.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "reports/audit_markdown.hpp"
#include "reports/csv.hpp"
#include "reports/json.hpp"
#include "reports/markdown.hpp"
#include "reports/output_file.hpp"

#include <fmt/format.h>

#include <array>

namespace ff::app {
namespace {

void write_markdown(const std::filesystem::path& folder, const studies::Store& /*store*/,
                    const studies::StudyResults& results) {
    reports::write_file(folder / "report.md", reports::markdown_report(results));
    if (!results.published) return;
    reports::write_file(folder / "audit.md",
                        reports::audit_markdown(results.published->tables, results.published->audit));
}

void write_csv(const std::filesystem::path& folder, const studies::Store& store, const studies::StudyResults& results) {
    reports::write_file(folder / "summary.csv",
                        [&](std::ostream& out) { reports::write_summary_csv(out, results.findings); });
    reports::write_file(folder / "slopes.csv", [&](std::ostream& out) { reports::write_slopes_csv(out, results); });
    if (!results.findings.plan.spec.coverage.empty()) {
        reports::write_file(folder / "coverage.csv",
                            [&](std::ostream& out) { reports::write_coverage_csv(out, results); });
    }
    reports::write_file(folder / "trials.csv", [&](std::ostream& out) { reports::write_trials_csv(out, store); });
}

void write_json(const std::filesystem::path& folder, const studies::Store& /*store*/,
                const studies::StudyResults& results) {
    reports::write_file(folder / "results.json", reports::results_json(results));
    reports::write_file(folder / "context.json", reports::context_json(results.context));
}

constexpr std::array<std::string_view, 3> names{"markdown", "csv", "json"};
constexpr std::array<std::string_view, 6> files{"report.md",  "audit.md",     "summary.csv",
                                                "trials.csv", "results.json", "context.json"};
constexpr std::array writers{write_markdown, write_csv, write_json};

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

void write_results(const std::filesystem::path& folder, const studies::Store& store,
                   const studies::StudyResults& results, std::span<const std::string_view> formats) {
    for (const std::string_view format : formats) {
        const auto found = std::find(names.begin(), names.end(), format);
        if (found == names.end()) {
            throw UserError(fmt::format("--format {} is unknown. {}Known: {}.", format, did_you_mean(format, names),
                                        fmt::join(names, ", ")));
        }
    }
    for (const std::string_view format : formats) {
        writers.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), format) - names.begin()))(
            folder, store, results);
    }
}

}  // namespace ff::app
