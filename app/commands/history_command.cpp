#include "app/commands/history_command.hpp"

#include "app/command_line/common_options.hpp"
#include "app/folders/output_folder.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "reports/html/trend_html.hpp"
#include "reports/terminal/trend_text.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/history.hpp"
#include "studies/verdicts/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace ff::app {
namespace {

using studies::FileKind;

studies::History load_history(const std::filesystem::path& file) {
    return studies::parse_history(studies::read_text_file(file, FileKind::estimates), file.string());
}

studies::History summary_of(const CheckCommand& command, std::vector<std::string>& left_out) {
    const auto text = studies::read_text_file(command.estimates, FileKind::estimates);
    const std::string origin = command.estimates.string();
    if (!studies::reports_means(text))
        return studies::summarise(studies::parse_estimates(text, origin), command.commit);
    return studies::summarise(studies::parse_reported(text, origin, studies::Errors::optional), command.commit,
                              left_out);
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

void expect_history(const CheckCommand& command) {
    if (command.history.empty()) return;
    if (command.estimates.empty())
        throw UserError("--history (it keeps what --estimates holds, and there is none). Add the option.");
    if (command.commit.empty())
        throw UserError("--history (a line of what?). Add --commit NAME, as --commit \"$(git rev-parse HEAD)\".");
    const std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/-";
    if (command.commit.size() > 100 || command.commit.find_first_not_of(allowed) != std::string::npos)
        throw UserError("--commit (letters, digits and ._/-, at most 100: the name of a commit). Give its hash.");
    if (!std::filesystem::exists(command.history)) return;
    if (has_commit(load_history(command.history), command.commit))
        throw UserError(
            fmt::format("--commit {} ({} has it already; counted twice it would look like two runs). Name "
                        "another run.",
                        command.commit, command.history.string()));
}

void add_to_history(const CheckCommand& command) {
    if (command.history.empty()) return;
    std::vector<std::string> left_out;
    const auto rows = summary_of(command, left_out);
    if (rows.empty())
        throw UserError(
            fmt::format("--history ({} has no quantity with one value: arrays and histograms are not "
                        "kept). Leave the option out.",
                        command.estimates.string()));
    const OutputFolder lock(folder_of(command.history), "history");
    studies::History history;
    if (std::filesystem::exists(command.history)) history = load_history(command.history);
    history.insert(history.end(), rows.begin(), rows.end());
    reports::write_file(command.history, studies::history_csv(history));
    if (command.quiet || command.json) return;
    fmt::print("History: {}{}\n", command.history.string(),
               left_out.empty() ? "" : fmt::format(" (not kept: {}, arrays)", fmt::join(left_out, ", ")));
}

void save_means(const CheckCommand& command) {
    const auto text = studies::read_text_file(command.estimates, FileKind::estimates);
    std::string means = text;
    if (studies::reports_means(text)) {
        static_cast<void>(studies::parse_reported(text, command.estimates.string(), studies::Errors::optional));
    } else {
        means = "quantity,mean,standard_error,n\n";
        for (const auto& row : studies::summarise(studies::parse_estimates(text, command.estimates.string()), "")) {
            if (row.standard_error == 0)
                throw UserError(
                    fmt::format("{}: all values of '{}' are equal (no spread is no evidence of precision). "
                                "Was every trial seeded alike?",
                                command.estimates.string(), row.quantity));
            means += fmt::format("{},{},{},{}\n", row.quantity, row.mean, row.standard_error, row.n);
        }
    }
    const OutputFolder lock(folder_of(command.save_baseline), "baseline");
    reports::write_file(command.save_baseline, means);
    if (!command.quiet) fmt::print("Baseline: {} (compare with it by --against)\n", command.save_baseline.string());
}

ExitCode trend(const TrendCommand& command) {
    if (!(command.alpha >= 1e-6 && command.alpha < 0.5))
        throw UserError(fmt::format("--alpha {} (1e-6 to below 0.5). Try 0.01.", command.alpha));
    const auto history = load_history(command.history);
    if (history.empty())
        throw UserError(fmt::format("{}: no lines (nothing would be compared). Fill it by 'ffstudy check --history'.",
                                    command.history.string()));
    const auto trends = find_trends(history, {.alpha = command.alpha, .seed = checked_seed(command.seed)});
    if (!command.out.empty())
        OutputFolder(command.out, "trend").write("trend.html", reports::trend_html(trends, command.alpha));
    if (!command.quiet) fmt::print("{}", reports::trend_text(trends, command.alpha));
    if (std::any_of(trends.begin(), trends.end(), [](const auto& t) { return t.changed; })) return ExitCode::failed;
    return std::any_of(trends.begin(), trends.end(), [](const auto& t) { return t.change.has_value(); })
               ? ExitCode::passed
               : ExitCode::inconclusive;
}

}  // namespace ff::app
