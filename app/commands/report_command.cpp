#include "app/commands/commands.hpp"

#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/terminal/terminal.hpp"
#include "studies/results/results.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::app {
namespace {

struct ReportCommand {
    std::filesystem::path results;  ///< folder or store
    std::filesystem::path out;      ///< empty: the folder of the store
    std::vector<std::string> formats;
    std::vector<std::string> pictures;  ///< pictures to draw as files: names or their beginnings; empty: all
    std::filesystem::path templates;    ///< folder of custom templates; empty: none
    bool quiet = false;
};

ExitCode report(const ReportCommand& command) {
    const auto templates = find_templates(command.templates);
    const auto file = store_of(command.results);
    const auto out = command.out.empty() ? file.parent_path() : command.out;
    const std::vector<std::string_view> named(command.formats.begin(), command.formats.end());
    const auto formats = named.empty() ? usual_formats() : std::span<const std::string_view>(named);
    expect_formats(formats);
    std::error_code missing;
    const auto store = open_results(file);
    const auto [results, to_the_end] = evaluate_until_stopped(store);
    OutputFolder folder(out.empty() ? "." : out, owner_of(store.plan().spec));
    if (std::filesystem::equivalent(file, folder.path() / "results.sqlite", missing)) folder.inherit("study ");
    const bool draws = std::any_of(formats.begin(), formats.end(),
                                   [](std::string_view format) { return format == "svg" || format == "pdf"; });
    if (draws) {
        const std::size_t count = chosen_pictures(results, command.pictures).size();
        if (!command.quiet && command.pictures.empty())
            say("note: drawing all {} pictures of the report; --pictures answer,convergence draws fewer.\n", count);
    } else if (!command.pictures.empty()) {
        throw UserError("--pictures (says which are drawn by --format svg or pdf). Add one of these.");
    }
    write_results(folder, {store, results, templates, command.pictures, command.quiet}, formats);
    if (!command.quiet)
        print_folded("{}\nResults: {}\n", reports::terminal_summary(results, style_of_stdout()), out.string());
    return to_the_end ? ExitCode::passed : ExitCode::interrupted;
}

}  // namespace

void add_report(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<ReportCommand>(everyday, "report", "Write the reports of a finished study again", report);
    sub.option("RESULTS", command.results, "Folder of a study, or its results.sqlite", {.is_required = true});
    sub.option("--format", command.formats,
               fmt::format("{} (default: {})", names_in_words("formats"), fmt::join(usual_formats(), ", ")),
               {.type = "FORMAT", .delimiter = ','});
    sub.option("--pictures", command.pictures,
               "Pictures for svg and pdf: names as 'ffstudy figure' lists them, or how they begin (default: all)",
               {.type = "PICTURE", .delimiter = ','});
    sub.option("--out", command.out, "Folder for the files (default: where the results lie)", {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for report.html", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
}

}  // namespace ff::app
