#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/options.hpp"
#include "app/commands/figure_command.hpp"
#include "app/commands/point_commands.hpp"

namespace ff::app {

// The commands besides those that run a study or compute form factors of a scene. Each function adds one with its
// options, which fill in `command`.

void add_report(ProgramDefinition& program, ReportCommand& command);
void add_figure(ProgramDefinition& program, FigureCommand& command);
void add_compare(ProgramDefinition& program, CompareCommand& command);
void add_merge(ProgramDefinition& program, MergeCommand& command);
void add_audit(ProgramDefinition& program, AuditCommand& command);
void add_check(ProgramDefinition& program, CheckCommand& command, OutsideOptions& outside);
void add_list(ProgramDefinition& program, ListCommand& command);
void add_explain(ProgramDefinition& program, ListCommand& command);
void add_points(ProgramDefinition& program, PointsCommand& command);
void add_check_sampler(ProgramDefinition& program, CheckSamplerCommand& command);

}  // namespace ff::app
