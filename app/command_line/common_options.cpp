#include "app/command_line/common_options.hpp"

#include "app/command_line/command_definition.hpp"
#include "app/process/limits.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "studies/readers/text_file.hpp"

#include <algorithm>
#include <random>
#include <string_view>
#include <thread>

namespace ff::app {
namespace {

constexpr std::uint64_t largest_seed = (1ULL << 63) - 1;  // study files hold it as a TOML integer
constexpr unsigned most_threads = 4096;

}  // namespace

Seed checked_seed(std::uint64_t seed) {
    if (seed > largest_seed) throw UserError("--seed {} (at most {}). Take a smaller one.", seed, largest_seed);
    return Seed{seed};
}

Seed fresh_seed() {
    std::random_device device;
    return Seed{std::uniform_int_distribution<std::uint64_t>(0, largest_seed)(device)};
}

unsigned thread_count(const std::optional<unsigned>& threads) {
    if (!threads) return std::max(1u, std::thread::hardware_concurrency());
    if (*threads == 0 || *threads > most_threads) {
        throw UserError("--threads {} (1 to {} are possible). Leave it out for all cores.", *threads, most_threads);
    }
    return *threads;
}

void add_outside_options(CommandDefinition& command, OutsideOptions& options, OutsideCodeFrom from) {
    command.option("--plugin", options.plugins, "Plug-in with samplers (.so); may be given several times",
                   {.type = "FILE", .takes_one_value = true});
    if (from == OutsideCodeFrom::plugins) return;
    command.option("--deadline", options.deadline, "Time for one run of a program: 90 (seconds), 15m (default: 60)",
                   {.type = "TIME"});
    if (from == OutsideCodeFrom::files_too)
        command.option("--no-commands", options.no_commands, "Refuse programs and plug-ins that the file names");
}

double deadline_of(const OutsideOptions& options) {
    const auto deadline = parse_duration(options.deadline, "--deadline");
    return deadline ? deadline->count() : studies::usual_deadline;
}

void load_plugins(const OutsideOptions& options) {
    for (const auto& plugin : options.plugins) studies::load_plugin(plugin);
}

void admit_code_of(const std::filesystem::path& file, studies::FileKind kind, const OutsideOptions& options,
                   Announcement announcement) {
    load_plugins(options);
    const double deadline = deadline_of(options);
    for (const auto& code : studies::outside_code(studies::read_text_file(file, kind), file.string())) {
        const bool plugin = code.kind == studies::OutsideCode::Kind::plugin;
        const std::string_view what = plugin ? "loads the plug-in" : "runs";
        if (options.no_commands)
            throw UserError(
                "{}: {} {} (--no-commands refuses it). Leave the option out where you trust "
                "the file.",
                code.place, what, code.text);
        if (announcement == Announcement::said) say("note: {} {} {}\n", code.place, what, code.text);
        studies::admit(code, file.parent_path(), deadline);
    }
}

}  // namespace ff::app
