#include "app/command_line/man_pages.hpp"

#include "app/command_line/command_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::app {
namespace {

/// Text as man(7) takes it: no escape, dash or request by accident.
std::string plain(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (safe.empty() || safe.back() == '\n') safe += letter == '.' || letter == '\'' ? "\\&" : "";
        if (letter == '\\') {
            safe += "\\e";
        } else if (letter == '-') {
            safe += "\\-";
        } else {
            safe += letter;
        }
    }
    return safe;
}

std::string title(std::string name, const std::string& version) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return fmt::format(".TH \"{}\" 1 \"\" \"ffstudy {}\" \"User Commands\"\n", plain(name), plain(version));
}

std::string entries(std::string_view heading, const std::vector<const CLI::Option*>& options) {
    if (options.empty()) return {};
    const CLI::Formatter help;
    std::string text = fmt::format(".SH {}\n", heading);
    for (const CLI::Option* option : options) {
        text +=
            fmt::format(".TP\n.BR \"{}\" \"{}\"\n{}\n", plain(help.make_option_name(option, option->get_positional())),
                        plain(help.make_option_opts(option)), plain(option->get_description()));
    }
    return text;
}

std::string synopsis(const CLI::App& command, const std::string& name) {
    std::string text = fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR]", plain(name));
    for (const CLI::Option* argument : shown_arguments(command))
        text += fmt::format(" {}", plain(CLI::Formatter().make_option_usage(argument)));
    return text + '\n';
}

ManPage page_of_command(const CLI::App& app, const CLI::App& command, const std::string& version) {
    const std::string name = fmt::format("{}-{}", app.get_name(), command.get_name());
    std::string text = title(name, version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(command.get_description()));
    text += synopsis(command, fmt::format("{} {}", app.get_name(), command.get_name()));
    text += entries("ARGUMENTS", shown_arguments(command));
    text += entries("OPTIONS", shown_options(command));
    text += fmt::format(".SH EXIT STATUS\n{}\n.SH SEE ALSO\n.BR {} (1)\n", plain(app.get_footer()), app.get_name());
    return {name + ".1", std::move(text)};
}

ManPage page_of_program(const CLI::App& app, const std::string& version) {
    std::string text = title(app.get_name(), version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", app.get_name(), plain(app.get_description()));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR] \\fICOMMAND\\fR\n.SH COMMANDS\n", app.get_name());
    for (const CLI::App* command : shown_commands(app)) {
        text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", app.get_name(), plain(command->get_name()),
                            plain(command->get_description()));
    }
    text += entries("OPTIONS", shown_options(app));
    text += fmt::format(".SH EXIT STATUS\n{}\n", plain(app.get_footer()));
    return {app.get_name() + ".1", std::move(text)};
}

}  // namespace

std::vector<ManPage> man_pages(const CLI::App& app, const std::string& version) {
    std::vector<ManPage> pages{page_of_program(app, version)};
    for (const CLI::App* command : shown_commands(app)) pages.push_back(page_of_command(app, *command, version));
    return pages;
}

}  // namespace ff::app
