#include "app/commands/commands.hpp"

#include "app/folders/result_files.hpp"
#include "app/folders/template_files.hpp"
#include "app/terminal/terminal_style.hpp"

#include "core/support/error.hpp"
#include "reports/comparison/run_comparison.hpp"
#include "studies/comparison/run_comparison.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace ff::app {
namespace {

/// The names of two folders, with as many of the folders above them as it takes to tell them apart.
std::array<std::string, 2> names_of(const std::filesystem::path& first, const std::filesystem::path& second) {
    using std::filesystem::path;
    path a = std::filesystem::absolute(first).lexically_normal().parent_path();
    path b = std::filesystem::absolute(second).lexically_normal().parent_path();
    path end_a = a.filename();
    path end_b = b.filename();
    while (end_a == end_b && a.has_relative_path() && b.has_relative_path()) {
        a = a.parent_path();
        b = b.parent_path();
        end_a = a.filename() / end_a;
        end_b = b.filename() / end_b;
    }
    return {end_a.string(), end_b.string()};
}

}  // namespace

ExitCode compare(const CompareCommand& command) {
    const auto first = store_of(command.first);
    const auto second = store_of(command.second);
    std::error_code missing;
    if (std::filesystem::equivalent(first, second, missing))
        throw UserError(fmt::format("{} is {} (a run is equal to itself). Give another one.", command.second.string(),
                                    command.first.string()));
    const auto templates = find_templates(command.templates);
    const auto open = [](const std::filesystem::path& file) {
        auto store = studies::Store::open(file);
        if (!store.was_checked()) note_unchecked(file);
        return store;
    };
    const auto comparison = studies::compare_runs(open(first), open(second), names_of(first, second));
    if (!command.out.empty()) {
        OutputFolder out(command.out, "comparison");
        out.write("comparison.md", reports::comparison_markdown(comparison));
        out.write("comparison.html", reports::comparison_html(comparison, templates));
    }
    if (command.json) {
        fmt::print("{}\n", reports::comparison_json(comparison));
    } else if (!command.quiet) {
        fmt::print("{}", reports::comparison_text(comparison, style_of_stdout()));
    }
    if (!command.quiet && !command.json && !command.out.empty())
        fmt::print("\nResults: {}\n", (command.out / "comparison.html").string());
    if (comparison.count(studies::Likeness::different) > 0) return ExitCode::failed;
    return comparison.count(studies::Likeness::untestable) > 0 ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace ff::app
