#include "app/commands.hpp"

#include "app/result_files.hpp"
#include "app/template_files.hpp"
#include "app/terminal_colour.hpp"

#include "core/error.hpp"
#include "reports/output_file.hpp"
#include "reports/run_comparison.hpp"
#include "studies/run_comparison.hpp"
#include "studies/store.hpp"

#include <fmt/format.h>

namespace ff::app {

ExitCode compare(const CompareCommand& command) {
    const auto first = store_of(command.first);
    const auto second = store_of(command.second);
    std::error_code missing;
    if (std::filesystem::equivalent(first, second, missing))
        throw UserError(fmt::format("{} is {} (a run is equal to itself). Give another one.", command.second.string(),
                                    command.first.string()));
    const auto templates = find_templates(command.templates);
    const auto comparison = studies::compare_runs(studies::Store::open(first), studies::Store::open(second));
    if (!command.out.empty()) {
        make_folder(command.out);
        reports::write_file(command.out / "comparison.md", reports::comparison_markdown(comparison));
        reports::write_file(command.out / "comparison.html", reports::comparison_html(comparison, templates));
    }
    if (!command.quiet) fmt::print("{}", reports::comparison_text(comparison, colour_of_stdout()));
    if (!command.quiet && !command.out.empty())
        fmt::print("\nResults: {}\n", (command.out / "comparison.html").string());
    if (comparison.count(studies::Likeness::different) > 0) return ExitCode::failed;
    return comparison.count(studies::Likeness::untestable) > 0 ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace ff::app
