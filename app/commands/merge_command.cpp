#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/form_factors/form_factor_rows.hpp"
#include "app/commands/form_factors/form_factor_run.hpp"

#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/terminal/terminal.hpp"
#include "studies/results/results.hpp"
#include "studies/run/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::app {
namespace {

/// The stores that are named, by themselves or by their folders. @throws UserError where one is to be written to
std::vector<std::filesystem::path> stores_of(const MergeCommand& command, const std::filesystem::path& target) {
    std::vector<std::filesystem::path> stores;
    for (const auto& source : command.sources) {
        stores.push_back(store_of(source));
        std::error_code missing;
        if (std::filesystem::equivalent(stores.back(), target, missing)) {
            throw UserError("--out {}: one of the stores to be merged lies there. Choose another folder.",
                            command.out.string());
        }
    }
    return stores;
}

/// "12 of 30 units are missing: 2, 5, 8, ..."
std::string units_in_words(const std::vector<std::size_t>& units, std::size_t all, std::string_view what) {
    constexpr std::size_t shown = 20;
    const std::size_t count = std::min(units.size(), shown);
    return fmt::format("{} of {} units {}: {}{}", units.size(), all, what,
                       fmt::join(units.begin(), units.begin() + static_cast<std::ptrdiff_t>(count), ", "),
                       units.size() > shown ? ", ..." : "");
}

ExitCode merge(const MergeCommand& command) {
    const std::filesystem::path& first = command.sources.front();
    const bool are_of_matrix = rows_of(first).has_value();
    for (const auto& source : command.sources) {
        if (rows_of(source).has_value() != are_of_matrix && std::filesystem::exists(source))
            throw UserError("{} is a shard of a matrix, and {} is not. Merge what belongs together.",
                            (are_of_matrix ? first : source).string(), (are_of_matrix ? source : first).string());
    }
    if (are_of_matrix) return merge_form_factors(command);
    if (command.randomisations)
        throw UserError("--randomisations: {} is no shard of a matrix. Leave it out.", first.string());
    end_on_signals(
        "\nstopped while stores were merged. Those that were given are as they were: run the same command again to "
        "resume.\n");
    const auto templates = find_templates({});
    const auto target = command.out / "results.sqlite";
    const auto sources = stores_of(command, target);
    const studies::StudyPlan plan = studies::Store::open(sources.front()).plan();
    OutputFolder out(command.out, owner_of(plan.spec));
    auto store = open_or_create(out, plan);
    const studies::MergeOutcome outcome = studies::merge_stores(sources, store);
    for (const std::size_t source : outcome.unchecked) note_unchecked(sources[source]);
    seal(store, command.quiet);
    if (!outcome.doubled.empty() && !command.quiet) {
        say("note: {}; their content is the same.\n",
            units_in_words(outcome.doubled, plan.units.size(), "are in more than one store"));
    }
    const auto [results, to_the_end] = evaluate_until_stopped(store, command.quiet);
    write_results(out, {store, results, templates}, usual_formats);
    if (!command.quiet) {
        print_folded("{}\nResults: {}\n", reports::terminal_summary(results, style_of_stdout()),
                     (command.out / "report.html").string());
    }
    if (outcome.missing.empty()) return to_the_end ? ExitCode::passed : ExitCode::interrupted;
    say("{}. Merge again with the shards that hold them, or run the study with --out {}.\n",
        units_in_words(outcome.missing, plan.units.size(), "are missing"), command.out.string());
    return ExitCode::inconclusive;
}

}  // namespace

void add_merge(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<MergeCommand>(laboratory, "merge", "Bring the results of shards together", merge);
    sub.option("RESULTS", command.sources, "Folders of the shards, or their results.sqlite", {.is_required = true});
    sub.option("--out", command.out, "Folder for the merged results", {.type = "DIR", .is_required = true});
    sub.option("--randomisations", command.randomisations,
               "Of a matrix, also write the 16 values behind each sampled entry (randomisations.npz)");
    add_verbosity(sub, command.quiet);
}

}  // namespace ff::app
