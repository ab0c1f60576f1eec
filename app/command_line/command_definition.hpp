#pragma once

#include "app/process/exit_code.hpp"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ff::app {

// The parts of the command line, as commands define them; only app/command_line/parser.cpp knows the library that
// parses it.

/// The variable that an option fills in. Its type decides which texts are values of the option: for a bool it is a flag
/// without a value, for a vector it takes several values; a function is called where the flag is given.
using OptionTarget = std::variant<bool*, double*, std::uint32_t*, std::uint64_t*, std::string*, std::filesystem::path*,
                                  std::optional<double>*, std::optional<std::uint32_t>*, std::optional<std::uint64_t>*,
                                  std::optional<std::string>*, std::vector<std::string>*,
                                  std::vector<std::filesystem::path>*, void (*)()>;

/// Which of the numbers that its target can hold an option accepts.
enum class Numbers { all, not_negative, positive };

struct OptionRules {
    std::string type{};                  ///< "DIR" of "--out DIR"; empty: that of the target
    std::vector<std::string> choices{};  ///< the only values; empty: all are
    Numbers numbers = Numbers::all;
    char delimiter = '\0';         ///< between values of a vector; '\0': none
    bool takes_one_value = false;  ///< a vector takes one value each time that it is given
    bool is_required = false;
    bool shows_default = false;
    std::vector<std::string> needs{};  ///< options, each as "--out"
    std::vector<std::string> excludes{};
};

struct OptionDefinition {
    std::string names;  ///< "--out" or "-q,--quiet"; of an argument, "STUDY"
    OptionTarget target;
    std::string description;
    OptionRules rules;
};

struct CommandDefinition {
    std::string group;  ///< heading of the command in --help; empty: it is hidden
    std::string name;
    std::string summary;
    std::vector<OptionDefinition> options;         ///< options and arguments, in the order of --help
    std::vector<std::string>* unparsed = nullptr;  ///< receives all after the command, including --help; null: nothing
    std::function<ExitCode()> action;

    /// @param target  of a type that OptionTarget lists; it lives until the action has ended
    template <class Target>
    OptionDefinition& option(std::string names, Target& target, std::string description, OptionRules rules = {}) {
        return options.emplace_back(
            OptionDefinition{std::move(names), &target, std::move(description), std::move(rules)});
    }
};

struct ProgramDefinition {
    std::string summary;
    std::string version;  ///< what --version prints
    std::string footer;
    std::deque<CommandDefinition> commands;  ///< in the order of --help within each group

    /// A command, and what its options fill in.
    template <class Options>
    struct Added {
        CommandDefinition& definition;
        Options& options;
    };

    /// Adds a command that acts on the options, once they are filled in.
    template <class Options>
    Added<Options> command(std::string group, std::string name, std::string command_summary,
                           std::function<ExitCode(const Options&)> act) {
        const auto options = std::make_shared<Options>();
        CommandDefinition& definition = commands.emplace_back(
            CommandDefinition{std::move(group), std::move(name), std::move(command_summary), {}, nullptr, {}});
        definition.action = [options, act = std::move(act)] { return act(*options); };
        return {definition, *options};
    }
};

}  // namespace ff::app
