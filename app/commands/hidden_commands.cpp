#include "app/commands/hidden_commands.hpp"

#include "app/command_line/man_pages.hpp"

#include "reports/files/output_file.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace ff::app {
namespace {

void add_complete(CLI::App& app, const NamesOfType& names, Action& action) {
    CLI::App* sub = app.add_subcommand("complete", "Say what may stand in place of the last word of a command line");
    sub->group("")->set_help_flag();
    sub->prefix_command();
    sub->callback([&app, sub, names, &action] {
        action = [&app, sub, names] {
            fmt::print("{}", in_lines(complete(app, sub->remaining(), names)));
            return ExitCode::passed;
        };
    });
}

void add_man_pages(CLI::App& app, Action& action) {
    CLI::App* sub = app.add_subcommand("man_pages", "Write the man pages into a folder")->group("");
    const CLI::Option* folder = sub->add_option("DIR")->required();
    sub->callback([&app, folder, &action] {
        action = [&app, folder] {
            const auto path = folder->as<std::filesystem::path>();
            std::filesystem::create_directories(path);
            for (const ManPage& page : man_pages(app, std::string(build_info::version)))
                reports::write_file(path / page.file, page.text);
            return ExitCode::passed;
        };
    });
}

}  // namespace

void add_hidden_commands(CLI::App& app, const NamesOfType& names, Action& action) {
    add_complete(app, names, action);
    add_man_pages(app, action);
}

}  // namespace ff::app
