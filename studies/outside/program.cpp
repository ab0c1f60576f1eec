#include "studies/outside/program.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <system_error>

namespace ff::studies {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view command_prefix = "command:";

/// "text#hash" in two; the hash may be empty.
std::pair<std::string_view, std::string_view> split_hash(std::string_view command) {
    const std::size_t at = command.rfind('#');
    if (at == std::string_view::npos || !is_hash(command.substr(at + 1))) return {command, {}};
    return {command.substr(0, at), command.substr(at + 1)};
}

/// Words between spaces; those in ' or " may have spaces, and lose the quotes.
std::vector<std::string> words_of_command(std::string_view command) {
    std::vector<std::string> words;
    char quote = 0;
    bool inside = false;
    for (const char c : command) {
        if (quote != 0 ? c == quote : c == '\'' || c == '"') {
            quote = quote != 0 ? '\0' : c;
            if (!inside) words.emplace_back();
            inside = true;
        } else if (c == ' ' && quote == 0) {
            inside = false;
        } else {
            if (!inside) words.emplace_back();
            inside = true;
            words.back() += c;
        }
    }
    if (quote != 0) throw UserError("command:{} (a quote {} is not closed). Close it.", command, quote);
    if (words.empty() || words.front().empty())
        throw UserError("command: (no program). Name it: command:./mine --n {n} --d {d} --seed {seed}");
    return words;
}

void replace_all(std::string& word, std::string_view what, const std::string& by) {
    for (std::size_t at = word.find(what); at != std::string::npos; at = word.find(what, at + by.size()))
        word.replace(at, what.size(), by);
}

/// Names and bytes of the words that are files: the program itself, a script.
Files files_of(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    Files files;
    std::error_code error;
    for (const std::string& word : words) {
        const bool is_program = &word == &words.front();
        if (is_program && word.find('/') == std::string::npos) continue;  // looked for on PATH, not here
        if (std::filesystem::is_regular_file(folder / word, error))
            files.emplace_back(word, read_regular_file(folder / word));
    }
    return files;
}

/// The last lines that a program wrote to stderr, in one.
std::string last_words(std::string_view errors) {
    constexpr std::size_t most = 400;
    while (!errors.empty() && (errors.back() == '\n' || errors.back() == ' ')) errors.remove_suffix(1);
    if (errors.empty()) return "it wrote nothing to stderr";
    const bool cut = errors.size() > most;
    if (cut) errors.remove_prefix(errors.size() - most);
    std::string line(errors);
    std::replace(line.begin(), line.end(), '\n', '|');
    return fmt::format("its stderr: {}{}", cut ? "…" : "", visible_text(line));
}

/// The name without its hash, as the files are now. @pre the name begins with the prefix
std::string name_now(std::string_view text, const std::filesystem::path& folder) {
    if (const auto problem = problem_with_name(text); !problem.empty())
        throw UserError("{}{} {} A script may hold them.", command_prefix, visible_text(text), problem);
    const auto files = files_of(words_of_command(text), folder);
    return files.empty() ? fmt::format("{}{}", command_prefix, text)
                         : fmt::format("{}{}#{}", command_prefix, text, hash_of(files));
}

/// Processes that answer requests of this thread. Programs live as long as this process, so that the address is a name.
thread_local std::map<const Program*, std::unique_ptr<ChildConversation>> conversations;

}  // namespace

bool names_command(std::string_view name) {
    return name.starts_with(command_prefix);
}

std::string full_command_name(std::string_view name, const std::filesystem::path& folder) {
    const auto [text, hash] = split_hash(name.substr(command_prefix.size()));
    std::string now = name_now(text, folder);
    return hash.empty() ? now : std::string(name);
}

Program::Program(std::string_view name, std::filesystem::path folder, double deadline)
    : text_(split_hash(name.substr(command_prefix.size())).first),
      words_(words_of_command(text_)),
      folder_(std::move(folder)),
      deadline_(deadline),
      full_name_(name_now(text_, folder_)),
      repeatable_(is_randomised(), {"prints", "{seed}", "leave {seed} and {trial} out"}) {
    const bool has_hash = name.size() > command_prefix.size() + text_.size();
    if (has_hash && full_name_ != name)
        throw UserError("{} (its files are others than before: {}). Bring them back, or leave the hash out.", name,
                        full_name_);
}

std::string Program::title() const {
    return fmt::format("{}{}", command_prefix, text_);
}

bool Program::has(std::string_view placeholder) const {
    return text_.find(placeholder) != std::string::npos;
}

void Program::expect_placeholders_among(std::vector<std::string_view> known) const {
    known.insert(known.end(), {"{seed}", "{trial}"});
    const std::string_view text = text_;
    for (std::size_t begin = text.find('{'); begin != std::string_view::npos; begin = text.find('{', begin + 1)) {
        const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", begin + 1);
        const bool of_a_shell = begin > 0 && text[begin - 1] == '$';
        if (end == std::string_view::npos || text[end] != '}' || end == begin + 1 || of_a_shell) continue;
        const std::string_view word = text.substr(begin, end + 1 - begin);
        if (std::find(known.begin(), known.end(), word) != known.end()) continue;
        throw UserError("{} ({} is not replaced by anything). {}There are {}; a script may hold other braces.",
                        visible_text(title()), word, did_you_mean(word, known), fmt::join(known, ", "));
    }
}

std::string Program::run(const std::string& place, Seed seed, Values values, std::uint64_t most_output) const {
    values.emplace_back("{seed}", std::to_string(seed.seed));
    values.emplace_back("{trial}", std::to_string(seed.trial));
    ChildCommand command{words_, folder_};
    for (std::string& word : command.words) {
        for (const auto& [placeholder, value] : values) replace_all(word, placeholder, value);
    }
    ChildOutput output = read_from_child(command, most_output, deadline_);
    expect_sound(place, output, most_output);
    return std::move(output.output);
}

std::string Program::ask(const std::string& place, const std::string& line, const ChildConversation::Size& size,
                         std::uint64_t most_output) const {
    auto& conversation = conversations[this];
    if (!conversation) {
        ChildCommand command{words_, folder_};
        for (std::string& word : command.words) replace_all(word, requests, "-");
        conversation = std::make_unique<ChildConversation>(command);
    }
    ChildOutput output = conversation->ask(line, size, most_output, deadline_);
    const bool whole = output.end == ChildOutput::End::exited && output.output.size() == size(output.output);
    if (whole) return std::move(output.output);
    conversation.reset();
    expect_sound(place, output, most_output);
    throw IoError("{}: ended before its answer was whole ({}). Let it answer until its input ends.", place,
                  last_words(output.errors));
}

void Program::hang_up() const {
    conversations.erase(this);
}

/// @throws IoError
void Program::expect_sound(const std::string& place, const ChildOutput& output, std::uint64_t most_output) const {
    const auto fail = [&](const std::string& problem) {
        throw IoError("{}: {} ({}). Run it by hand: what was saved stays.", place, problem, last_words(output.errors));
    };
    switch (output.end) {
        case ChildOutput::End::exited:
            if (output.code != 0) fail(fmt::format("ended with exit code {}", output.code));
            break;
        case ChildOutput::End::killed:
            fail(fmt::format("was ended by signal {}", output.code));
            break;
        case ChildOutput::End::too_slow:
            fail(fmt::format("did not end within {} s, and was stopped", deadline_));
            break;
        case ChildOutput::End::too_large:
            fail(fmt::format("printed more than {} bytes, and was stopped", most_output));
            break;
    }
}

}  // namespace ff::studies
