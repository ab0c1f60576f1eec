#include "app/commands/commands.hpp"
#include "app/commands/form_factor_run.hpp"
#include "app/folders/output_folder.hpp"
#include "app/terminal/messages.hpp"
#include "app/terminal/terminal_style.hpp"

#include "core/support/error.hpp"
#include "reports/csv/heat_csv.hpp"
#include "reports/terminal/heat_text.hpp"
#include "reports/words/form_factor_warnings.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/heat/heat.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace ff::app {

ExitCode heat(const HeatCommand& command) {
    if (!(command.scale >= 1e-9 && command.scale <= 1e9))
        throw UserError(fmt::format("--scale {} (1e-9 to 1e9 metres). Write 0.001 for millimetres.", command.scale));
    auto kept = prepare_form_factors(command.factors);
    studies::expect_dense(kept.scene, "heat");
    const auto materials = studies::load_materials(command.materials, kept.scene.faces);
    std::optional<OutputFolder> out;
    if (!command.factors.out.empty()) out.emplace(command.factors.out, "heat", std::vector<std::string>{"heat.csv"});
    for (const std::string& warning : materials.warnings) say("warning: {}\n", warning);
    const bool by_signal = compute_form_factors(command.factors, kept);
    for (const std::string& warning : reports::form_factor_warnings({kept.scene, kept.request, kept.matrix}))
        say("warning: {}\n", warning);
    const auto flows = studies::find_heat_flows(kept.scene, kept.matrix, materials, command.scale);
    const reports::HeatReport report{kept.scene, kept.request, materials, flows};
    if (!command.factors.quiet) fmt::print("{}", reports::heat_text(report, style_of_stdout()));
    if (out) out->write("heat.csv", [&](std::ostream& file) { reports::write_heat_csv(file, report); });
    if (by_signal) return ExitCode::interrupted;
    const bool trusted = studies::is_trusted(kept.scene, kept.matrix, kept.request.tolerance);
    return trusted && flows.within(command.flow_tolerance) ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace ff::app
