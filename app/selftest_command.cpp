#include "app/commands.hpp"

#include "app/common_options.hpp"
#include "app/result_files.hpp"
#include "app/study_files.hpp"

#include "reports/output_file.hpp"
#include "reports/selftest_markdown.hpp"
#include "studies/form_factors/coverage.hpp"
#include "studies/gates/bands_file.hpp"
#include "studies/selftest/selftest.hpp"

#include <fmt/format.h>

namespace ff::app {
namespace {

/// Writes and prints the page; some contradictions make it a failure.
ExitCode conclude(const SelftestCommand& command, const std::string& text, std::size_t contradictions) {
    if (!command.out.empty()) {
        make_folder(command.out);
        reports::write_file(command.out / "selftest.md", text);
    }
    if (!command.quiet) fmt::print("{}", text);
    return contradictions > 0 ? ExitCode::failed : ExitCode::passed;
}

}  // namespace

ExitCode gates_selftest(const SelftestCommand& command) {
    studies::SelftestOptions options;
    options.threads = thread_count(command.threads);
    if (command.seed) options.seed = checked_seed(*command.seed);
    if (command.repetitions) options.repetitions = *command.repetitions;
    if (command.seeds) options.seeds = *command.seeds;
    const auto selftest = studies::run_selftest(studies::load_bands(studies_folder() / "gates/controls.toml"), options);
    const std::string text = reports::selftest_markdown(selftest);
    return conclude(command, text, selftest.contradictions());
}

ExitCode form_factors_selftest(const SelftestCommand& command) {
    studies::FormFactorCoverageOptions options;
    options.threads = thread_count(command.threads);
    if (command.seed) options.seed = checked_seed(*command.seed);
    if (command.seeds) options.seeds = *command.seeds;
    if (command.tolerance) options.tolerance = *command.tolerance;
    options.scenes = command.scenes;
    const auto coverage = studies::measure_form_factor_coverage(options);
    const std::string text = reports::form_factor_coverage_markdown(coverage);
    return conclude(command, text, coverage.contradictions());
}

}  // namespace ff::app
