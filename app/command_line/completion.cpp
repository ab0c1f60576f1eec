#include "app/command_line/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ff::app {
namespace {

using Words = std::span<const std::string>;

constexpr std::array<std::string_view, 6> of_files{"FILE", "RESULTS", "BANDS", "TABLES", "STUDY", "SCENE"};

void add_values(Completions& completions, std::string_view type, const NamesOfType& names) {
    completions.words = names(type);
    if (type == "DIR") completions.paths = Completions::Paths::folders;
    if (std::find(of_files.begin(), of_files.end(), type) != of_files.end())
        completions.paths = Completions::Paths::files;
}

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
    add_values(completions, option.type, names);
    for (auto& word : completions.words) word.text.insert(0, kept);
    return completions;
}

const OptionModel* find_option(const CommandModel& command, std::string_view name) {
    for (const OptionModel& option : command.options) {
        if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
    }
    return nullptr;
}

bool takes_value(const OptionModel* option) {
    return option != nullptr && option->takes_value;
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
            const OptionModel* option = find_option(command, word);
            if (takes_value(option)) pending = option;
        } else {
            ++place;
        }
    }
    if (pending != nullptr) return values(*pending, "", last, names);
    const auto equals = last.find('=');
    if (last.starts_with('-') && equals != std::string_view::npos) {
        const OptionModel* option = find_option(command, last.substr(0, equals));
        if (!takes_value(option)) return {};
        return values(*option, std::string(last.substr(0, equals + 1)), last.substr(equals + 1), names);
    }
    if (last.starts_with('-')) return options(command, given);
    if (command.arguments.empty()) return options(command, given);
    const OptionModel& argument = command.arguments[std::min(place, command.arguments.size() - 1)];
    if (place >= command.arguments.size() && !argument.takes_many) return options(command, given);
    if (argument.type == "COMMAND") return commands(program);
    return values(argument, "", last, names);
}

}  // namespace

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
    std::erase_if(completions.words, [&](const auto& word) { return !word.text.starts_with(last); });
    return completions;
}

std::string in_lines(const Completions& completions) {
    std::string lines;
    for (const auto& [text, summary] : completions.words) lines += fmt::format("{}\t{}\n", text, summary);
    if (completions.paths == Completions::Paths::files) lines += ":files\n";
    if (completions.paths == Completions::Paths::folders) lines += ":folders\n";
    return lines;
}

}  // namespace ff::app
