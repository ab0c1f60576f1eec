#include "app/command_line/parser.hpp"

#include "app/command_line/usage_errors.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace ff::app {
namespace {

constexpr const char* program_name = "ffstudy";

CLI::Option* add_option(CLI::App& command, const OptionDefinition& definition) {
    return std::visit(
        [&](auto* target) {
            using Target = std::remove_pointer_t<decltype(target)>;
            if constexpr (std::is_function_v<Target>)
                return command.add_flag_callback(definition.names, target, definition.description);
            else if constexpr (std::is_same_v<Target, bool>)
                return command.add_flag(definition.names, *target, definition.description);
            else
                return command.add_option(definition.names, *target, definition.description);
        },
        definition.target);
}

void set_rules(CLI::Option& option, const OptionRules& rules) {
    if (!rules.type.empty()) option.type_name(rules.type);
    if (!rules.choices.empty()) option.check(CLI::IsMember(rules.choices));
    if (rules.numbers == Numbers::not_negative) option.check(CLI::NonNegativeNumber);
    if (rules.numbers == Numbers::positive) option.check(CLI::PositiveNumber);
    if (rules.delimiter != '\0') option.delimiter(rules.delimiter);
    if (rules.takes_one_value) option.allow_extra_args(false);
    if (rules.is_required) option.required();
    if (rules.shows_default) option.capture_default_str();
    // The name of an argument stands for its type, so that help says "STUDY", not "STUDY TEXT".
    if (option.get_positional() && option.get_type_name() == "TEXT") option.type_name("");
}

/// Whether options are to know which others they need or exclude: to parse, they have to. Help says it in words.
enum class Relations { known, in_words };

void add_command(CLI::App& app, const CommandDefinition& definition, Relations relations) {
    CLI::App* command = app.add_subcommand(definition.name, definition.summary)->group(definition.group);
    if (definition.unparsed != nullptr) {
        command->set_help_flag();
        command->prefix_command();
    }
    std::vector<CLI::Option*> options;
    for (const OptionDefinition& option : definition.options) {
        options.push_back(add_option(*command, option));
        set_rules(*options.back(), option.rules);
    }
    // Only now do all options exist that others name.
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (relations == Relations::in_words) {
            const auto& needs = definition.options[i].rules.needs;
            if (!needs.empty())
                options[i]->description(
                    fmt::format("{} (with {})", options[i]->get_description(), fmt::join(needs, " and ")));
            continue;
        }
        for (const std::string& name : definition.options[i].rules.needs) options[i]->needs(command->get_option(name));
        for (const std::string& name : definition.options[i].rules.excludes)
            options[i]->excludes(command->get_option(name));
    }
}

/// The definitions in the form of the library; what is parsed goes to their targets.
std::unique_ptr<CLI::App> make_app(const ProgramDefinition& program, Relations relations) {
    auto app = std::make_unique<CLI::App>(program.summary, program_name);
    app->set_help_flag("-h,--help", "Show this help");
    app->set_version_flag("-V,--version", program.version, "Show the version (alone also -v)");
    app->require_subcommand(0, 1);  // an unknown option is named first; that a command is missing, later
    app->footer(program.footer);
    for (const CommandDefinition& command : program.commands) add_command(*app, command, relations);
    app->get_formatter()->label("SUBCOMMAND", "COMMAND");
    app->get_formatter()->label("Positionals", "Arguments");
    app->get_formatter()->label("REQUIRED", "");
    return app;
}

std::string broken_into_lines(const std::string& text, std::size_t width) {
    constexpr std::string_view blanks = " \t\n\v\f\r";
    std::string out;
    std::size_t used = 0;
    for (const std::string_view word : split_words(text, blanks)) {
        const bool breaks = used > 0 && used + 1 + word.size() > width;
        if (used > 0) out += breaks ? '\n' : ' ';
        used = breaks || used == 0 ? word.size() : used + 1 + word.size();
        out += word;
    }
    return out;
}

/// The words that describe an option to a reader.
struct OptionWords {
    std::string value;  ///< " DIR", " N ..."; empty for a flag and for arguments
    std::string description;
};

OptionWords words_of(const CLI::Option& option) {
    OptionWords words{"", option.get_description()};
    const std::string type = option.get_type_name();  // "DIR", "UINT:POSITIVE", "AXIS:{x,y,z}"
    const std::size_t colon = std::min(type.find(':'), type.size());
    const std::string name = type.substr(0, colon);
    const bool is_flag = option.get_expected_max() == 0;
    if (!is_flag && !name.empty()) words.value = " " + (name == "UINT" ? "N" : name == "FLOAT" ? "X" : name);
    if (option.get_expected_max() >= CLI::detail::expected_max_vector_size) words.value += " ...";
    const std::string rule = type.substr(colon);
    const bool is_choice = rule.starts_with(":{");
    const std::string choices = is_choice ? rule.substr(2, rule.size() - 3) : std::string();
    if (is_choice && words.description.find(choices.substr(choices.rfind(',') + 1)) == std::string::npos)
        words.description += fmt::format(" ({})", fmt::join(CLI::detail::split(choices, ','), ", "));
    if (option.get_required() && !option.get_positional()) words.description += " (required)";
    std::string value = option.get_default_str();
    if (value.starts_with('[') && value.ends_with(']')) value = value.substr(1, value.size() - 2);  // a list
    if (!value.empty() && !is_flag) words.description += fmt::format(" (default: {})", value);
    return words;
}

/// Sets the words of options, broken into lines so that help fits into this many columns. For help only: they stay in
/// the options.
void lay_out_help(CLI::App& app, std::size_t columns) {
    const auto& formatter = dynamic_cast<const CLI::Formatter&>(*app.get_formatter());
    const std::size_t before = formatter.get_column_width();
    constexpr std::size_t least = 20;
    const std::size_t width = std::max(columns, before + least) - before;
    const auto lay_out = [&](CLI::App& command) {
        for (CLI::Option* option : command.get_options()) {
            const OptionWords words = words_of(*option);
            if (!words.value.empty()) option->option_text(words.value.substr(1));
            option->description(broken_into_lines(words.description, width));
        }
        command.footer(broken_into_lines(command.get_footer(), columns));
    };
    lay_out(app);
    for (CLI::App* command : app.get_subcommands(nullptr)) {
        command->description(broken_into_lines(command->get_description(), width));
        lay_out(*command);
    }
}

OptionModel model_of(const CLI::Option& option) {
    OptionModel model;
    for (const std::string& name : option.get_snames()) model.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) model.names.push_back("--" + name);
    if (option.get_positional()) model.names.push_back(option.get_name(true));
    model.name = option.get_name();
    model.usage = CLI::Formatter().make_option_usage(&option);
    OptionWords words = words_of(option);
    model.notes = std::move(words.value);
    model.description = std::move(words.description);
    model.delimiter = option.get_delimiter();
    model.is_argument = option.get_positional();
    model.type = model.is_argument && option.get_type_name().empty() ? model.name : option.get_type_name();
    model.takes_value = option.get_expected_max() > 0;
    model.takes_many = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    return model;
}

CommandModel model_of(const CLI::App& command) {
    CommandModel model{command.get_name(), command.get_description(), {}, {}};
    for (const CLI::Option* option : command.get_options())
        (option->get_positional() ? model.arguments : model.options).push_back(model_of(*option));
    return model;
}

ProgramModel model_of_program(const CLI::App& app) {
    ProgramModel model{model_of(app), app.get_footer(), {}};
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        if (!command->get_group().empty()) model.commands.push_back(model_of(*command));
    }
    return model;
}

/// The command that was given; the program itself where there is none.
const CLI::App& given_command(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

/// The library's message about options that exclude each other, but only about the first two of them, in the order of
/// their definitions: the library keeps sets of pointers, as the heap has them.
std::string exclusion(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const auto excluded = option->get_excludes();
        for (const CLI::Option* other : command.get_options()) {
            if (option->count() > 0 && other->count() > 0 && std::ranges::count(excluded, other) > 0)
                return fmt::format("{} excludes {}", option->get_name(), other->get_name());
        }
    }
    return {};
}

[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = given_command(app);
    const ProgramModel program = model_of_program(app);
    const CommandModel model = model_of(command);
    const UsageProblems problems{program, &command == &app ? nullptr : &model};
    switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
        case CLI::ExitCodes::ExtrasError:
            throw UserError(problems.unexpected(app.remaining(true)));
        case CLI::ExitCodes::ConversionError:
            throw UserError(problems.not_converted(error.what()));
        case CLI::ExitCodes::RequiredError:
            throw UserError(problems.missing(error.what()));
        case CLI::ExitCodes::ArgumentMismatch:
            throw UserError(problems.number_of_values(error.what()));
        case CLI::ExitCodes::ExcludesError:
            throw UserError(problems.other(exclusion(command)));
        default:
            throw UserError(problems.other(error.what()));
    }
}

/// The name of the command that this word is with underscores instead of hyphens, or the word as it is.
const char* present_name(const ProgramDefinition& program, const char* word) {
    const auto alike = [](char a, char b) { return a == b || (a == '-' && b == '_'); };
    for (const CommandDefinition& command : program.commands) {
        if (std::ranges::equal(command.name, std::string_view(word), alike)) return command.name.c_str();
    }
    return word;
}

}  // namespace

ParsedCommandLine parse(const ProgramDefinition& program, std::span<char* const> arguments, std::size_t columns) {
    const auto app = make_app(program, Relations::known);
    std::vector<const char*> words(arguments.begin(), arguments.end());
    if (words.size() > 1) words[1] = present_name(program, words[1]);
    if (words.size() == 2 && std::string_view(words[1]) == "-v") words[1] = "-V";  // nothing that could be verbose
    try {
        app->parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) refuse(*app, error);
        if (dynamic_cast<const CLI::CallForHelp*>(&error) == nullptr) return {nullptr, app->version() + "\n"};
        const CLI::App& asked = given_command(*app);
        return {nullptr, help_of(program, &asked == app.get() ? std::string() : asked.get_name(), columns)};
    }
    const CLI::App& given = given_command(*app);
    for (const CLI::Option* option : given.get_options()) refuse_unmeant_values(model_of(*option), option->results());
    if (&given == app.get()) return {nullptr, help_of(program, "", columns)};
    const CommandDefinition& command = *std::ranges::find(program.commands, given.get_name(), &CommandDefinition::name);
    if (command.unparsed != nullptr) *command.unparsed = given.remaining();
    return {&command, {}};
}

std::string help_of(const ProgramDefinition& program, const std::string& command, std::size_t columns) {
    const auto app = make_app(program, Relations::in_words);
    lay_out_help(*app, columns);
    // Not app->help(), which is that of the command that was given.
    if (command.empty()) return app->get_formatter()->make_help(app.get(), app->get_name(), CLI::AppFormatMode::Normal);
    const auto names = command_names(model_of_program(*app));
    const std::string name = present_name(program, command.c_str());
    if (std::find(names.begin(), names.end(), name) != names.end()) {
        CLI::App& asked = *app->get_subcommand(name);
        asked.description(broken_into_lines(asked.get_description(), columns));
        return asked.help(app->get_name());
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UserError("unknown command '{}'. {}See 'ffstudy --help'.", command, did_you_mean(command, known));
}

ProgramModel model_of(const ProgramDefinition& program) {
    return model_of_program(*make_app(program, Relations::in_words));
}

}  // namespace ff::app
