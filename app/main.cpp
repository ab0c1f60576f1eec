#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/hidden_commands.hpp"
#include "core/support/instruction_sets.hpp"

#include <cstdlib>

namespace {

using namespace ff::app;

/// With the instruction set that tests ask for: results are the same with all of them.
void add_commands(ProgramDefinition& program) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it
    if (const char* const set = std::getenv("FFSTUDY_INSTRUCTION_SET")) ff::use_instruction_set(set);
    for (const auto add : {add_form_factors, add_heat, add_convert, add_run, add_report, add_figure, add_compare,
                           add_list, add_explain, add_help, add_convergence, add_radiosity, add_enclosure, add_merge,
                           add_audit, add_check, add_points, add_check_sampler, add_built_in_studies})
        add(program);
    add_hidden_commands(program, listed_for_type);
}

}  // namespace

// A failure while an error is being reported ends in the handler that `guarded` sets.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    return run_program({argv, static_cast<std::size_t>(argc)}, "Form-factor methods under honest statistics.",
                       add_commands);
}
