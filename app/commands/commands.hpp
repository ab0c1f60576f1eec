#pragma once

namespace ff::app {

struct ProgramDefinition;

// Each function adds one or more commands with their options; in the order of --help.

void add_form_factors(ProgramDefinition& program);
void add_heat(ProgramDefinition& program);
void add_convert(ProgramDefinition& program);
void add_run(ProgramDefinition& program);
void add_report(ProgramDefinition& program);
void add_figure(ProgramDefinition& program);
void add_compare(ProgramDefinition& program);
void add_list(ProgramDefinition& program);
void add_explain(ProgramDefinition& program);
void add_convergence(ProgramDefinition& program);
void add_radiosity(ProgramDefinition& program);
void add_enclosure(ProgramDefinition& program);
void add_merge(ProgramDefinition& program);
void add_audit(ProgramDefinition& program);
void add_check(ProgramDefinition& program);
void add_points(ProgramDefinition& program);
void add_check_sampler(ProgramDefinition& program);
void add_built_in_studies(ProgramDefinition& program);

}  // namespace ff::app
