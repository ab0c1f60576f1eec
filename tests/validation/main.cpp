#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/folders/output_folder.hpp"
#include "app/folders/study_files.hpp"

#include "core/support/error.hpp"
#include "reports/markdown/selftest_markdown.hpp"
#include "studies/form_factors/coverage.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/heat/coverage.hpp"
#include "studies/selftest/selftest.hpp"
#include "studies/verdicts/bands_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace ff::app {
namespace {

constexpr std::uint64_t most_repetitions = 1'000'000'000;

/// @throws UserError for 0 and for more than `most`
std::uint64_t checked_count(std::string_view option, std::uint64_t count, std::uint64_t most) {
    if (count >= 1 && count <= most) return count;
    throw UserError(fmt::format("{} {} (from 1 to {}). Take another number.", option, count, most));
}

/// Writes and prints the page; some contradictions make it a failure.
ExitCode conclude(const SelftestCommand& command, const std::string& text, std::size_t contradictions) {
    if (!command.out.empty()) OutputFolder(command.out, "selftest").write("selftest.md", text);
    if (!command.quiet) fmt::print("{}", text);
    return contradictions > 0 ? ExitCode::failed : ExitCode::passed;
}

studies::FormFactorCoverageOptions coverage_options(const SelftestCommand& command) {
    studies::FormFactorCoverageOptions options;
    options.threads = thread_count(command.threads);
    if (command.seed) options.seed = checked_seed(*command.seed);
    if (command.seeds) options.seeds = checked_count("--seeds", *command.seeds, most_seeds);
    if (command.tolerance) options.tolerance = *command.tolerance;
    options.scenes = command.scenes;
    return options;
}

}  // namespace

ExitCode gates_selftest(const SelftestCommand& command) {
    studies::SelftestOptions options;
    options.threads = thread_count(command.threads);
    if (command.seed) options.seed = checked_seed(*command.seed);
    if (command.repetitions)
        options.repetitions = checked_count("--repetitions", *command.repetitions, most_repetitions);
    if (command.seeds) options.seeds = checked_count("--seeds", *command.seeds, most_seeds);
    const auto selftest = studies::run_selftest(
        studies::load_bands(studies_folder() / "gates/controls.toml", studies::read_experiment), options);
    const std::string text = reports::selftest_markdown(selftest);
    return conclude(command, text, selftest.contradictions());
}

ExitCode form_factors_selftest(const SelftestCommand& command) {
    auto options = coverage_options(command);
    if (command.scenes.empty()) {
        options.adversarial = 20 * options.seeds;
        options.walls = 2 * options.seeds;
    }
    const auto coverage = studies::measure_form_factor_coverage(options);
    const std::string text = reports::form_factor_coverage_markdown(coverage);
    return conclude(command, text, coverage.contradictions());
}

ExitCode heat_selftest(const SelftestCommand& command) {
    const auto coverage = studies::measure_flow_coverage(coverage_options(command));
    return conclude(command, reports::flow_coverage_markdown(coverage), coverage.contradictions());
}

}  // namespace ff::app
