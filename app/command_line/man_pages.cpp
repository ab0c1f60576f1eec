#include "app/command_line/man_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace ff::app {
namespace {

/// Text for man(7): without accidental escapes, dashes or requests.
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

std::string entries(std::string_view heading, const std::vector<OptionModel>& options) {
    if (options.empty()) return {};
    std::string text = fmt::format(".SH {}\n", heading);
    for (const OptionModel& option : options) {
        text += fmt::format(".TP\n.BR \"{}\" \"{}\"\n{}\n", plain(fmt::format("{}", fmt::join(option.names, ","))),
                            plain(option.notes), plain(option.description));
    }
    return text;
}

std::string synopsis(const CommandModel& command, const std::string& name) {
    std::string text = fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR]", plain(name));
    for (const OptionModel& argument : command.arguments) text += fmt::format(" {}", plain(argument.usage));
    return text + '\n';
}

ManPage page_of_command(const ProgramModel& of, const CommandModel& command, const std::string& version) {
    const std::string& program = of.program.name;
    const std::string name = fmt::format("{}-{}", program, command.name);
    std::string text = title(name, version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(command.description));
    text += synopsis(command, fmt::format("{} {}", program, command.name));
    text += entries("ARGUMENTS", command.arguments);
    text += entries("OPTIONS", command.options);
    text += fmt::format(".SH EXIT STATUS\n{}\n.SH SEE ALSO\n.BR {} (1)\n", plain(of.footer), program);
    return {name + ".1", std::move(text)};
}

ManPage page_of_program(const ProgramModel& of, const std::string& version) {
    const std::string& name = of.program.name;
    std::string text = title(name, version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", name, plain(of.program.description));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR] \\fICOMMAND\\fR\n.SH COMMANDS\n", name);
    for (const CommandModel& command : of.commands) {
        text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", name, plain(command.name), plain(command.description));
    }
    text += entries("OPTIONS", of.program.options);
    text += fmt::format(".SH EXIT STATUS\n{}\n", plain(of.footer));
    return {name + ".1", std::move(text)};
}

}  // namespace

std::vector<ManPage> man_pages(const ProgramModel& program, const std::string& version) {
    std::vector<ManPage> pages{page_of_program(program, version)};
    for (const CommandModel& command : program.commands) pages.push_back(page_of_command(program, command, version));
    return pages;
}

}  // namespace ff::app
