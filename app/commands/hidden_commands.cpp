#include "app/commands/hidden_commands.hpp"

#include "app/command_line/program.hpp"
#include "app/terminal/output.hpp"

#include "core/support/words.hpp"
#include "reports/files/output_file.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

namespace ff::app {
namespace {

/// Completions of the last word of a command line.
struct Completions {
    std::vector<Listed> words;  ///< words that begin with the given text
    enum class Paths { none, folders, files } paths = Paths::none;
};

using Words = std::span<const std::string>;

constexpr std::array<std::string_view, 6> of_files{"FILE", "RESULTS", "BANDS", "TABLES", "STUDY", "SCENE"};

Completions commands(const ProgramModel& program) {
    Completions completions;
    for (const CommandModel& command : program.commands)
        completions.words.push_back({command.name, command.description});
    return completions;
}

/// The values that an option or argument takes, each after `before`: "--format=csv," where a list has been begun.
Completions values(const OptionModel& option, const std::string& before, std::string_view begun,
                   const NamesOfType& names) {
    const auto comma = option.delimiter == '\0' ? std::string_view::npos : begun.rfind(option.delimiter);
    const std::string kept = before + std::string(begun.substr(0, comma == std::string_view::npos ? 0 : comma + 1));
    Completions completions;
    completions.words = names(option.type);
    for (Listed& word : completions.words) word.name.insert(0, kept);
    if (option.type == "DIR") completions.paths = Completions::Paths::folders;
    if (std::find(of_files.begin(), of_files.end(), option.type) != of_files.end())
        completions.paths = Completions::Paths::files;
    return completions;
}

/// The option of this name if it takes a value; else null.
const OptionModel* option_with_value(const CommandModel& command, std::string_view name) {
    for (const OptionModel& option : command.options) {
        if (option.takes_value && std::ranges::count(option.names, name) > 0) return &option;
    }
    return nullptr;
}

Completions options(const CommandModel& command, Words given) {
    Completions completions;
    for (const OptionModel& option : command.options) {
        for (const std::string& name : option.names) {
            if (name.starts_with("--") && std::find(given.begin(), given.end(), name) == given.end())
                completions.words.push_back({name, option.description});
        }
    }
    return completions;
}

/// Completes the words after a command. @param given words between it and the last one
Completions of_command(const ProgramModel& program, const CommandModel& command, Words given, std::string_view last,
                       const NamesOfType& names) {
    const OptionModel* pending = nullptr;
    std::size_t place = 0;
    for (const std::string& word : given) {
        if (pending != nullptr) {
            pending = nullptr;
        } else if (word.starts_with('-')) {
            pending = option_with_value(command, word);
        } else {
            ++place;
        }
    }
    if (pending != nullptr) return values(*pending, "", last, names);
    const auto equals = last.find('=');
    if (last.starts_with('-') && equals != std::string_view::npos) {
        const OptionModel* option = option_with_value(command, last.substr(0, equals));
        if (option == nullptr) return {};
        return values(*option, std::string(last.substr(0, equals + 1)), last.substr(equals + 1), names);
    }
    const bool arguments_are_given =
        place >= command.arguments.size() && (command.arguments.empty() || !command.arguments.back().takes_many);
    if (last.starts_with('-') || arguments_are_given) return options(command, given);
    const OptionModel& argument = command.arguments[std::min(place, command.arguments.size() - 1)];
    if (argument.type == "COMMAND") return commands(program);
    return values(argument, "", last, names);
}

/// Commands, options and values, from the definitions that --help shows: an option's type, or an argument's name, tells
/// what it takes. @param words from the program's name on; the last one, possibly empty, is completed
Completions complete(const ProgramModel& program, Words words, const NamesOfType& names) {
    if (words.size() < 2) return {};
    const std::string& last = words.back();
    const Words given = words.subspan(1, words.size() - 2);
    Completions completions;
    const auto named =
        std::find_if(given.begin(), given.end(), [](const auto& word) { return !word.starts_with('-'); });
    if (named == given.end()) {
        completions = last.starts_with('-') ? options(program.program, given) : commands(program);
    } else {
        const auto command = std::find_if(program.commands.begin(), program.commands.end(),
                                          [&](const CommandModel& each) { return each.name == *named; });
        if (command == program.commands.end()) return {};
        completions = of_command(program, *command, given.subspan(static_cast<std::size_t>(named - given.begin()) + 1),
                                 last, names);
    }
    std::erase_if(completions.words, [&](const auto& word) { return !word.name.starts_with(last); });
    return completions;
}

/// The completions for scripts in app/completion/: lines "text<tab>summary", then ":files" or ":folders".
std::string in_lines(const Completions& completions) {
    std::string lines;
    for (const auto& [name, summary] : completions.words) lines += fmt::format("{}\t{}\n", name, summary);
    if (completions.paths == Completions::Paths::files) lines += ":files\n";
    if (completions.paths == Completions::Paths::folders) lines += ":folders\n";
    return lines;
}

struct ManPage {
    std::string file;  ///< "ffstudy-run.1"
    std::string text;  ///< man(7)
};

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

std::string title(const std::string& name) {
    return fmt::format(".TH \"{}\" 1 \"\" \"ffstudy {}\" \"User Commands\"\n", plain(in_capitals(name)),
                       plain(build_info::version));
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

ManPage page_of_command(const ProgramModel& of, const CommandModel& command) {
    const std::string& program = of.program.name;
    const std::string name = fmt::format("{}-{}", program, command.name);
    std::string text = title(name);
    text += fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(command.description));
    text += synopsis(command, fmt::format("{} {}", program, command.name));
    text += entries("ARGUMENTS", command.arguments);
    text += entries("OPTIONS", command.options);
    text += fmt::format(".SH EXIT STATUS\n{}\n.SH SEE ALSO\n.BR {} (1)\n", plain(of.footer), program);
    return {name + ".1", std::move(text)};
}

ManPage page_of_program(const ProgramModel& of) {
    const std::string& name = of.program.name;
    std::string text = title(name);
    text += fmt::format(".SH NAME\n{} \\- {}\n", name, plain(of.program.description));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR] \\fICOMMAND\\fR\n.SH COMMANDS\n", name);
    for (const CommandModel& command : of.commands) {
        text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", name, plain(command.name), plain(command.description));
    }
    text += entries("OPTIONS", of.program.options);
    text += fmt::format(".SH EXIT STATUS\n{}\n", plain(of.footer));
    return {name + ".1", std::move(text)};
}

/// One page for the program and one for each command, from the definitions that --help shows.
std::vector<ManPage> man_pages(const ProgramModel& program) {
    std::vector<ManPage> pages{page_of_program(program)};
    for (const CommandModel& command : program.commands) pages.push_back(page_of_command(program, command));
    return pages;
}

void add_complete(ProgramDefinition& program, const NamesOfType& names) {
    const auto [command, words] = program.command<std::vector<std::string>>(
        hidden, "complete", "Say what may stand in place of the last word of a command line",
        [&program, names](const std::vector<std::string>& given) {
            print_verbatim(in_lines(complete(model_of(program), given, names)));
            return ExitCode::passed;
        });
    command.unparsed = &words;
}

void add_man_pages(ProgramDefinition& program) {
    const auto [command, folder] = program.command<std::filesystem::path>(
        hidden, "man_pages", "Write the man pages into a folder", [&program](const std::filesystem::path& place) {
            std::filesystem::create_directories(place);
            for (const ManPage& page : man_pages(model_of(program))) reports::write_file(place / page.file, page.text);
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
