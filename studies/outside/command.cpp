#include "studies/outside/command.hpp"

#include "core/support/child_process.hpp"
#include "core/support/error.hpp"
#include "samplers/added.hpp"
#include "samplers/outside_points.hpp"
#include "studies/point_files/content.hpp"
#include "studies/point_files/point_file.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using samplers::AddedSampler;
using samplers::SetRequest;

constexpr std::string_view prefix = "command:";

/// Of processor time for a point, very roughly: starting a program takes milliseconds. Makes short units of work.
constexpr double nanoseconds_of_a_point = 2e4;

/// "text#hash" in two; the hash may be empty.
std::pair<std::string_view, std::string_view> split_hash(std::string_view command) {
    const std::size_t at = command.rfind('#');
    if (at == std::string_view::npos || !is_hash(command.substr(at + 1))) return {command, {}};
    return {command.substr(0, at), command.substr(at + 1)};
}

/// Words between spaces; those in ' or " may have spaces, and lose the quotes.
std::vector<std::string> split_words(std::string_view command) {
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
    if (quote != 0) throw UserError(fmt::format("command:{} (a quote {} is not closed). Close it.", command, quote));
    if (words.empty() || words.front().empty())
        throw UserError("command: (no program). Name it: command:./mine --n {n} --d {d} --seed {seed}");
    return words;
}

void replace_all(std::string& word, std::string_view what, const std::string& by) {
    for (std::size_t at = word.find(what); at != std::string::npos; at = word.find(what, at + by.size()))
        word.replace(at, what.size(), by);
}

/// The words that are files: the program itself, a script.
AddedSampler::Content files_of(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    AddedSampler::Content files;
    std::error_code error;
    for (const std::string& word : words) {
        const bool is_program = &word == &words.front();
        if (is_program && word.find('/') == std::string::npos) continue;  // looked for on PATH, not here
        if (std::filesystem::is_regular_file(folder / word, error)) files.emplace_back(word, read_bytes(folder / word));
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

class Program {
  public:
    Program(std::string text, std::filesystem::path folder, double deadline)
        : text_(std::move(text)), words_(split_words(text_)), folder_(std::move(folder)), deadline_(deadline) {}

    [[nodiscard]] bool has(std::string_view placeholder) const { return text_.find(placeholder) != std::string::npos; }

    [[nodiscard]] samplers::PointSet make_set(const SetRequest& request) const { return parse(run(request), request); }

    /// Once, before the first points.
    void expect_repeatable(std::uint64_t points, std::size_t dimension) {
        const std::lock_guard lock(mutex_);
        if (was_checked_) return;
        const SetRequest request{points, dimension, 0x5eed0123456789ab, 0};
        const SetRequest another{points, dimension, 0x0123456789ab5eed, 1};
        const auto once = parse(run(request), request);
        if (once.coordinate != parse(run(request), request).coordinate)
            throw UserError(
                fmt::format("{}: run twice, it prints different points (they must follow from seed and sizes alone, "
                            "not from the time). Let its random numbers follow from {{seed}}.",
                            place(request)));
        const bool varies = has("{seed}") || has("{trial}");
        if (varies && once.coordinate == parse(run(another), another).coordinate)
            throw UserError(fmt::format(
                "{}: prints the same points for every seed (trials would be equal). Let its random numbers follow from "
                "{{seed}}, or leave {{seed}} and {{trial}} out where the points are fixed.",
                place(request)));
        was_checked_ = true;
    }

  private:
    [[nodiscard]] std::string place(const SetRequest& request) const {
        return fmt::format("command:{} ({})", text_, in_words(request));
    }

    [[nodiscard]] std::string run(const SetRequest& request) const {
        samplers::expect_whole(fmt::format("command:{}", text_), request);
        ChildCommand command{words_, folder_};
        for (std::string& word : command.words) {
            replace_all(word, "{n}", std::to_string(request.points));
            replace_all(word, "{d}", std::to_string(request.dimension));
            replace_all(word, "{seed}", std::to_string(request.seed));
            replace_all(word, "{trial}", std::to_string(request.trial));
        }
        constexpr std::uint64_t bytes_of_a_number = 64;  // in text, with much to spare
        const std::uint64_t most = 65536 + request.points * (request.dimension + 4) * bytes_of_a_number;
        ChildOutput output = read_from_child(command, most, deadline_);
        const auto fail = [&](const std::string& problem) {
            throw IoError(fmt::format("{}: {} ({}). Run it by hand: what was saved stays.", place(request), problem,
                                      last_words(output.errors)));
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
                fail(fmt::format("printed more than {} bytes, and was stopped", most));
                break;
        }
        return std::move(output.output);
    }

    [[nodiscard]] samplers::PointSet parse(const std::string& output, const SetRequest& request) const {
        auto set = parse_points(output, place(request));
        if (set.sets != 1 || set.points != request.points || set.dimension < request.dimension)
            throw UserError(
                fmt::format("{}: printed {} set{} of {} points of {} coordinates. Print one set of {{n}} points with "
                            "at least {{d}} coordinates.",
                            place(request), set.sets, set.sets == 1 ? "" : "s", set.points, set.dimension));
        return set;
    }

    std::string text_;
    std::vector<std::string> words_;
    std::filesystem::path folder_;
    double deadline_;
    std::mutex mutex_;
    bool was_checked_ = false;
};

}  // namespace

bool names_command(std::string_view sampler) {
    return sampler.starts_with(prefix);
}

std::string full_command_name(std::string_view sampler, const std::filesystem::path& folder) {
    const auto [text, hash] = split_hash(sampler.substr(prefix.size()));
    if (const auto problem = problem_with_name(text); !problem.empty())
        throw UserError(fmt::format("{} {} A script may hold them.", visible_text(sampler), problem));
    const auto words = split_words(text);
    if (!hash.empty()) return std::string(sampler);
    const auto files = files_of(words, folder);
    return files.empty() ? std::string(sampler) : fmt::format("{}#{}", sampler, hash_of(files));
}

const samplers::CatalogueEntry& load_command(std::string_view sampler, const std::filesystem::path& folder,
                                             double deadline) {
    const auto [text, hash] = split_hash(sampler.substr(prefix.size()));
    const std::string now = full_command_name(fmt::format("{}{}", prefix, text), folder);
    if (!hash.empty() && now != sampler)
        throw UserError(fmt::format(
            "{} (its files are others than before: {}). Bring them back, or leave the hash out.", sampler, now));
    auto program = std::make_shared<Program>(std::string(text), folder, deadline);
    samplers::SamplerInfo traits;
    traits.randomised = program->has("{seed}") || program->has("{trial}");
    traits.nanoseconds = nanoseconds_of_a_point;
    const auto fill = samplers::parts_of([program](const SetRequest& request) { return program->make_set(request); });
    auto make = [program, fill, randomised = traits.randomised](const samplers::PointSetSpec& spec) {
        program->expect_repeatable(spec.points, spec.dimension);
        return samplers::outside_points(spec.points, randomised, fill);
    };
    return samplers::add(std::make_unique<AddedSampler>(
        AddedSampler::Texts{now, "points that a program prints",
                            "The program is run for each set of points, and once more at first to see that it prints "
                            "the same again. What it promises is its author's affair; ffstudy check-sampler asks of it "
                            "what the program's own samplers keep."},
        traits, std::vector<std::uint64_t>{}, std::move(make)));
}

}  // namespace ff::studies
