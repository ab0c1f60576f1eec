#include "app/command_line/command_model.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace ff::app {
namespace {

std::string in_lines(const std::string& text, std::size_t width) {
    std::string out;
    std::size_t used = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool breaks = used > 0 && used + 1 + word.size() > width;
        if (used > 0) out += breaks ? '\n' : ' ';
        used = breaks || used == 0 ? word.size() : used + 1 + word.size();
        out += word;
    }
    return out;
}

}  // namespace

std::vector<const CLI::App*> shown_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

const CLI::App* find_command(const CLI::App& app, std::string_view name) {
    for (const CLI::App* command : shown_commands(app)) {
        if (command->get_name() == name) return command;
    }
    return nullptr;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : shown_commands(app)) names.push_back(command->get_name());
    return names;
}

std::string help_of_command(const CLI::App& app, const std::string& name) {
    // Not app.help(), which is that of the command that was given.
    if (name.empty()) return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
    if (const CLI::App* command = find_command(app, name)) return command->help(app.get_name());
    const auto names = command_names(app);
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UserError(fmt::format("unknown command '{}'. {}See 'ffstudy --help'.", name, did_you_mean(name, known)));
}

std::vector<const CLI::Option*> shown_options(const CLI::App& command) {
    return command.get_options(
        [](const CLI::Option* option) { return !option->get_group().empty() && option->nonpositional(); });
}

std::vector<const CLI::Option*> shown_arguments(const CLI::App& command) {
    return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

bool is_flag(const CLI::Option& option) {
    return option.get_type_size() == 0;
}

bool takes_many(const CLI::Option& argument) {
    return argument.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string value_type(const CLI::Option& option) {
    return option.get_positional() && option.get_type_name().empty() ? option.get_name() : option.get_type_name();
}

void fit_descriptions(CLI::App& app, std::size_t columns) {
    const std::size_t before = app.get_formatter()->get_column_width();
    constexpr std::size_t least = 20;
    const std::size_t width = std::max(columns, before + least) - before;
    const auto fit = [&](CLI::App& command) {
        for (CLI::Option* option : command.get_options())
            option->description(in_lines(option->get_description(), width));
        command.footer(in_lines(command.get_footer(), columns));
    };
    fit(app);
    for (CLI::App* command : app.get_subcommands(nullptr)) {
        command->description(in_lines(command->get_description(), width));
        fit(*command);
    }
}

void name_types_of_arguments(CLI::App& app) {
    for (CLI::App* command : app.get_subcommands(nullptr)) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_positional() && option->get_type_name() == "TEXT") option->type_name("");
        }
    }
}

}  // namespace ff::app
