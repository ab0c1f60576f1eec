#include "app/commands/hidden_commands.hpp"

#include "app/command_line/man_pages.hpp"
#include "app/command_line/parser.hpp"
#include "app/command_line/program.hpp"

#include "reports/files/output_file.hpp"

#include "app/build_info.hpp"
#include "app/terminal/output.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ff::app {
namespace {

using Words = std::vector<std::string>;

void add_complete(ProgramDefinition& program, const NamesOfType& names) {
    const auto [command, words] =
        program.command<Words>(hidden, "complete", "Say what may stand in place of the last word of a command line",
                               [&program, names](const Words& given) {
                                   print_verbatim(in_lines(complete(model_of(program), given, names)));
                                   return ExitCode::passed;
                               });
    command.unparsed = &words;
}

void add_man_pages(ProgramDefinition& program) {
    const auto [command, folder] = program.command<std::filesystem::path>(
        hidden, "man_pages", "Write the man pages into a folder", [&program](const std::filesystem::path& place) {
            std::filesystem::create_directories(place);
            for (const ManPage& page : man_pages(model_of(program), std::string(build_info::version)))
                reports::write_file(place / page.file, page.text);
            return ExitCode::passed;
        });
    command.option("DIR", folder, "", {.is_required = true});
}

}  // namespace

void add_hidden_commands(ProgramDefinition& program, const NamesOfType& names) {
    add_complete(program, names);
    add_man_pages(program);
}

}  // namespace ff::app
