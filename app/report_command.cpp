#include "app/commands.hpp"

#include "app/result_files.hpp"
#include "app/template_files.hpp"
#include "app/terminal_colour.hpp"

#include "reports/terminal.hpp"
#include "studies/results.hpp"
#include "studies/store.hpp"

#include <fmt/format.h>

namespace ff::app {

ExitCode report(const ReportCommand& command) {
    const auto templates = find_templates(command.templates);
    const auto file = store_of(command.results);
    const auto out = command.out.empty() ? file.parent_path() : command.out;
    expect_room_for_results(out);
    const std::vector<std::string_view> named(command.formats.begin(), command.formats.end());
    const auto formats = named.empty() ? usual_formats() : std::span<const std::string_view>(named);
    expect_formats(formats);
    const auto store = studies::Store::open(file);
    const auto [results, to_the_end] = evaluate_until_stopped(store);
    if (!command.out.empty()) make_folder(command.out);
    write_results(out, {store, results, templates}, formats);
    if (!command.quiet)
        fmt::print("{}\nResults: {}\n", reports::terminal_summary(results, colour_of_stdout()), out.string());
    return to_the_end ? ExitCode::passed : ExitCode::interrupted;
}

}  // namespace ff::app
