#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/comparison/run_comparison.hpp"
#include "studies/comparison/run_comparison.hpp"
#include "studies/store/store.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace ff::app {
namespace {

struct CompareCommand {
    std::filesystem::path first;  ///< folder or store, optionally with a method: "results/a:sobol"
    std::filesystem::path second;
    std::filesystem::path out;        ///< empty: nothing is written
    std::filesystem::path templates;  ///< folder of custom templates; empty: none
    bool json = false;                ///< instead of text
    bool quiet = false;
};

/// The names of the folders of two stores, with as many of the folders above them as it takes to distinguish them; of
/// stores in one folder, with their own names.
std::array<std::string, 2> names_of_stores(const std::filesystem::path& first, const std::filesystem::path& second) {
    using std::filesystem::path;
    path a = std::filesystem::absolute(first).lexically_normal().parent_path();
    path b = std::filesystem::absolute(second).lexically_normal().parent_path();
    if (a == b) return {(a.filename() / first.filename()).string(), (b.filename() / second.filename()).string()};
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

/// One side of a comparison: a run, or one of its methods.
struct Side {
    std::filesystem::path results;
    std::string method;  ///< empty: all
};

/// Reads RESULTS or RESULTS:METHOD; a path that exists is a path, whatever it contains.
Side read_side(const std::filesystem::path& given) {
    if (std::filesystem::exists(given)) return {given, {}};
    const std::string text = given.string();
    for (auto colon = text.find(':'); colon != std::string::npos; colon = text.find(':', colon + 1)) {
        if (std::filesystem::exists(text.substr(0, colon))) return {text.substr(0, colon), text.substr(colon + 1)};
    }
    return {given, {}};
}

/// @throws UserError where the two cannot be compared
void expect_two(const CompareCommand& command, const Side& first, const Side& second, bool same_run) {
    if (first.method.empty() != second.method.empty())
        throw UserError("{} and {} (only one names a method). Name one of each, RESULTS:METHOD.",
                        command.first.string(), command.second.string());
    if (!same_run || first.method != second.method) return;
    throw UserError(
        "{} is {} (a run is equal to itself). Give another one, or two of its methods: "
        "RESULTS:METHOD.",
        command.second.string(), command.first.string());
}

ExitCode compare(const CompareCommand& command) {
    const Side one = read_side(command.first);
    const Side other = read_side(command.second);
    const auto first = store_of(one.results);
    const auto second = store_of(other.results);
    std::error_code missing;
    const bool same_run = std::filesystem::equivalent(first, second, missing);
    expect_two(command, one, other, same_run);
    const auto templates = find_templates(command.templates);
    const bool of_methods = !one.method.empty();
    auto names = same_run ? std::array{one.method, other.method} : names_of_stores(first, second);
    if (of_methods && !same_run) names = {names[0] + ":" + one.method, names[1] + ":" + other.method};
    const auto comparison = studies::compare_runs(
        open_results(first), open_results(second), names,
        of_methods ? std::optional(studies::MethodNames{one.method, other.method}) : std::nullopt);
    if (!command.out.empty()) {
        OutputFolder out(command.out, "comparison");
        out.write("comparison.md", reports::comparison_markdown(comparison));
        out.write("comparison.html", reports::comparison_html(comparison, templates));
    }
    if (command.json) {
        print_verbatim(reports::comparison_json(comparison) + "\n");
    } else if (!command.quiet) {
        print_folded(reports::comparison_text(comparison, style_of_stdout()));
        if (!command.out.empty()) print_folded("\nResults: {}\n", (command.out / "comparison.html").string());
    }
    if (comparison.cells.empty()) {
        const studies::Lead lead = comparison.lead_at_equal_evaluations();
        return lead.first + lead.second > 0 ? ExitCode::failed : ExitCode::inconclusive;
    }
    if (comparison.count(studies::Likeness::different) > 0) return ExitCode::failed;
    return comparison.count(studies::Likeness::untestable) > 0 ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace

void add_compare(ProgramDefinition& program) {
    const auto [sub, command] = program.command<CompareCommand>(
        everyday, "compare", "Show two runs side by side: what differs, and with what confidence", compare);
    sub.option("A", command.first, "Folder of a study, or its results.sqlite; of one method: RESULTS:METHOD",
               {.type = "RESULTS", .is_required = true});
    sub.option("B", command.second, "The other", {.type = "RESULTS", .is_required = true});
    sub.option("--out", command.out, "Folder for comparison.md and comparison.html (default: none is written)",
               {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for comparison.html", {.type = "DIR"});
    sub.option("--json", command.json, "Print JSON");
    add_verbosity(sub, command.quiet);
}

}  // namespace ff::app
