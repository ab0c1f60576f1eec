#include "app/commands/hidden_commands.hpp"

#include "app/command_line/man_pages.hpp"
#include "app/command_line/parser.hpp"
#include "app/command_line/program.hpp"

#include "reports/files/output_file.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ff::app {
namespace {

void add_complete(ProgramDefinition& program, const NamesOfType& names) {
    CommandDefinition& command =
        program.command(hidden, "complete", "Say what may stand in place of the last word of a command line");
    const auto words = std::make_shared<std::vector<std::string>>();
    command.unparsed = words.get();
    command.action = [&program, words, names] {
        fmt::print("{}", in_lines(complete(model_of(program), *words, names)));
        return ExitCode::passed;
    };
}

void add_man_pages(ProgramDefinition& program) {
    CommandDefinition& command = program.command(hidden, "man_pages", "Write the man pages into a folder");
    const auto folder = std::make_shared<std::filesystem::path>();
    command.option("DIR", *folder, "", {.is_required = true});
    command.action = [&program, folder] {
        std::filesystem::create_directories(*folder);
        for (const ManPage& page : man_pages(model_of(program), std::string(build_info::version)))
            reports::write_file(*folder / page.file, page.text);
        return ExitCode::passed;
    };
}

}  // namespace

void add_hidden_commands(ProgramDefinition& program, const NamesOfType& names) {
    add_complete(program, names);
    add_man_pages(program);
}

}  // namespace ff::app
