#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/definitions.hpp"
#include "app/commands/form_factor_definitions.hpp"
#include "app/commands/gates/gate_commands.hpp"
#include "app/commands/hidden_commands.hpp"
#include "app/commands/study_definitions.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace ff::app;

/// What all commands fill in; they are called after everything is parsed.
struct Commands {
    RunCommand run_command;
    ReportCommand report_command;
    FigureCommand figure_command;
    MergeCommand merge_command;
    CompareCommand compare_command;
    AuditCommand audit_command;
    CheckCommand check_command;
    OutsideOptions check_outside;
    ff::studies::ConvergenceRequest convergence_request;
    RadiosityOptions radiosity_options;
    EnclosureCommand enclosure_command;
    FormFactorsCommand form_factors_command;
    PointsCommand points_command;
    CheckSamplerCommand check_sampler_command;
    HeatCommand heat_command;
    ConvertCommand convert_command;
    ListCommand list_command;
};

std::vector<Completions::Word> words_of_type(std::string_view type) {
    std::vector<Completions::Word> words;
    for (auto& [name, summary] : listed_for_type(type)) words.push_back({std::move(name), std::move(summary)});
    return words;
}

void add_commands(ProgramDefinition& program, Commands& all) {
    add_form_factors(program, all.form_factors_command);
    add_heat(program, all.heat_command);
    add_convert(program, all.convert_command);
    add_run(program, all.run_command);
    add_report(program, all.report_command);
    add_figure(program, all.figure_command);
    add_compare(program, all.compare_command);
    add_list(program, all.list_command);
    add_explain(program, all.list_command);
    add_help(program);
    add_convergence(program, all.convergence_request, all.run_command);
    add_radiosity(program, all.radiosity_options, all.run_command);
    add_enclosure(program, all.enclosure_command);
    add_merge(program, all.merge_command);
    add_audit(program, all.audit_command);
    add_check(program, all.check_command, all.check_outside);
    add_points(program, all.points_command);
    add_check_sampler(program, all.check_sampler_command);
    add_built_in_studies(program, all.run_command);
    add_hidden_commands(program, words_of_type);
}

}  // namespace

// What goes wrong while an error is told ends in the handler that `guarded` sets.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    Commands commands;
    return run_program({argv, static_cast<std::size_t>(argc)}, "Form-factor methods under honest statistics.",
                       [&](ProgramDefinition& program) { add_commands(program, commands); });
}
