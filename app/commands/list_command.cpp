#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/terminal/output.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "reports/text/scene_text.hpp"
#include "samplers/outside/added.hpp"
#include "studies/explain/explain.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::app {
namespace {

/// Options of `ffstudy list` and `ffstudy explain`.
struct ListCommand {
    std::string name;  ///< kind, or what to explain; empty: an overview
    OutsideOptions outside;
    bool json = false;
};

/// The explanation of one thing by `explain`.
struct Explanation {
    std::string kind;
    std::string name;
    std::string summary;
    std::string details;
    std::string reference;  ///< key of docs/references.md; empty: none
};

Explanation explanation(std::string kind, const studies::Description& of) {
    return {std::move(kind), std::string(of.name), std::string(of.summary), std::string(of.details),
            std::string(of.reference)};
}

void show(const Explanation& explained) {
    print_folded("{} ({})\n{}\n", explained.name, explained.kind, explained.summary);
    if (!explained.details.empty())
        print_folded("\n{}{}", explained.details, explained.details.ends_with('\n') ? "" : "\n");
    if (!explained.reference.empty()) print_folded("\nSource: [{}], see docs/references.md\n", explained.reference);
}

std::string_view beside_its_sizes(samplers::Sizes sizes) {
    return sizes == samplers::Sizes::powers         ? "; others lose the net property"
           : sizes == samplers::Sizes::fourth_power ? " only (k^2 for points on one patch)"
                                                    : "";
}

Explanation explanation(const samplers::SamplerInfo& info) {
    return {
        "sampler", std::string(info.name), std::string(info.summary),
        fmt::format("{}\n\nSizes:  {}{}\nRandom: {}", info.details, sizes_in_words(info), beside_its_sizes(info.sizes),
                    info.randomised ? "yes, every trial has points of its own" : "no, one trial says all"),
        std::string(info.reference)};
}

Explanation explanation(const Configuration& configuration) {
    const std::string_view no_scene = why_no_scene(configuration.kind);
    const std::string scene = no_scene.empty() ? fmt::format("{} (scene), face {} to face {}", configuration.scene_name,
                                                             configuration.from + 1, configuration.to + 1)
                                               : fmt::format("none: {}", no_scene);
    return {"configuration", std::string(configuration.name), std::string(configuration.summary),
            fmt::format("Exact:    {}\nFrom:     {}\nOccluded: {}\nScene:    {}", exact_digits(configuration),
                        configuration.formula, configuration.occluded ? "in part" : "no", scene),
            std::string(configuration.reference)};
}

/// Everything that has a description of its own.
std::vector<Explanation> described() {
    std::vector<Explanation> all;
    for (const auto& entry : samplers::catalogue()) all.push_back(explanation(entry.info));
    for (const auto& [kind, plural, descriptions] : studies::all_choices()) {
        for (const auto& description : descriptions) all.push_back(explanation(std::string(kind), description));
    }
    for (const Format& format : all_formats())
        all.push_back(
            {"format", std::string(format.name), std::string(format.files), "What is in them: docs/results.md.", ""});
    for (const auto& control : studies::controls())
        all.push_back(explanation(fmt::format("control {}, broken on purpose", control.kind), control.description));
    return all;
}

/// "box:2x1x0.5" is explained under the name of its pattern.
std::string_view pattern_of(std::string_view name) {
    return name.starts_with("box:") ? "box:AxBxC" : name;
}

/// The scene of that name, built in or in a file; empty where it is neither.
/// @throws UserError where a file, or the measures of a scene, are wrong
std::optional<Scene> find_scene(const std::string& name) {
    studies::SceneSource source = studies::scene_source(name);
    if (source.is_file()) {
        source.text = studies::read_scene_file(source.name);
        return studies::make_scene(source);
    }
    const std::string_view family = std::string_view(name).substr(0, name.find(':'));
    const auto scenes = configuration_scene_names();
    const bool known = std::find(scenes.begin(), scenes.end(), family) != scenes.end();
    return known || family == "cube" || (name.starts_with("box:") && name != "box:AxBxC")
               ? std::optional(studies::make_scene(name))
               : std::nullopt;
}

/// "form-factors", "Form factor" and "form_factor" are one term.
std::string as_term(std::string text) {
    for (char& c : text)
        c = c == '-' || c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (text.size() > 2 && text.ends_with('s')) text.pop_back();
    return text;
}

/// Everything with that name. @throws UserError where there is nothing
std::vector<Explanation> explanations_of(const std::string& name, const std::optional<Scene>& scene) {
    if (studies::names_point_file(name) || studies::names_command(name) || samplers::find_added(name) != nullptr)
        return {explanation(studies::sampler_of_user(name).info)};
    std::vector<Explanation> found;
    std::vector<std::string> names;
    const auto add_if_named = [&](Explanation explained, bool named) {
        names.push_back(explained.name);
        if (named) found.push_back(std::move(explained));
    };
    for (Explanation& explained : described()) {
        const bool named = explained.name == pattern_of(name);
        add_if_named(std::move(explained), named);
    }
    for (const Configuration& of : configurations())
        add_if_named(explanation(of), of.name == name || of.id == name || of.scene_name == name);
    for (const auto& study : built_in_studies()) {
        names.push_back(study.name);
        if (study.name != name) continue;
        found.push_back({"study", name, study.title,
                         fmt::format("{}\n{}", study.file.string(), studies::to_toml(studies::load_study(study.file))),
                         ""});
    }
    for (const Term& term : glossary())
        add_if_named({"term", term.name, term.meaning, "", ""}, as_term(term.name) == as_term(name));
    if (scene) {
        auto [summary, details] = reports::scene_text(*scene, studies::explain_scene(*scene));
        found.push_back({"scene", scene->name, std::move(summary), std::move(details), ""});
    }
    if (!found.empty()) return found;
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UserError("'{}' is unknown. {}See 'ffstudy list'.", name, did_you_mean(name, known));
}

std::vector<std::string> names_of_kind(const ListedKind& kind) {
    std::vector<std::string> names;
    for (const Listed& row : listed(kind.plural)) names.push_back(row.name);
    return names;
}

/// Prints the number of things of each kind and the first few names; then how to see more.
void print_kinds() {
    constexpr std::size_t shown = 3;
    for (const ListedKind& kind : listed_kinds()) {
        auto names = names_of_kind(kind);
        const std::size_t number = names.size();
        names.resize(std::min(number, shown));
        print_folded("{:<15} {:>2}  {}{}\n", kind.plural, number, fmt::join(names, ", "), number > shown ? ", …" : "");
    }
    print_folded("\nAll of a kind: 'ffstudy list samplers'. More about one: 'ffstudy explain sobol'.\n");
}

void print_kinds_as_json() {
    nlohmann::ordered_json kinds;
    for (const ListedKind& kind : listed_kinds()) kinds[std::string(kind.plural)] = names_of_kind(kind);
    print_verbatim(kinds.dump(2) + "\n");
}

ExitCode list(const ListCommand& command) {
    load_plugins(command.outside);
    if (command.name.empty()) {
        command.json ? print_kinds_as_json() : print_kinds();
        return ExitCode::passed;
    }
    const auto rows = listed(command.name);
    if (command.json) {
        auto array = nlohmann::ordered_json::array();
        for (const Listed& row : rows) array.push_back({{"name", row.name}, {"summary", row.summary}});
        print_verbatim(array.dump(2) + "\n");
        return ExitCode::passed;
    }
    std::size_t width = 0;
    for (const Listed& row : rows) width = std::max(width, row.name.size());
    for (const Listed& row : rows) print_folded("{:<{}}  {}\n", row.name, width, row.summary);
    return ExitCode::passed;
}

ExitCode explain(const ListCommand& command) {
    if (command.name.empty()) return list(command);
    load_plugins(command.outside);
    const auto scene = find_scene(command.name);
    const auto found = explanations_of(command.name, scene);
    if (command.json) {
        auto array = nlohmann::ordered_json::array();
        for (const auto& [kind, name, summary, details, reference] : found) {
            array.push_back(
                {{"kind", kind}, {"name", name}, {"summary", summary}, {"details", details}, {"reference", reference}});
        }
        print_verbatim(array.dump(2) + "\n");
    } else {
        for (const Explanation& explained : found) {
            if (&explained != &found.front()) print_folded("\n");
            show(explained);
        }
    }
    if (!scene || scene->empty_box) return ExitCode::passed;
    for (const std::string& doubt : studies::doubts_about(*scene)) say("warning: {}\n", doubt);
    return ExitCode::passed;
}

void add_listing(ProgramDefinition& program, const std::string& name, const std::string& summary,
                 ExitCode (*act)(const ListCommand&), const std::string& argument, const std::string& description) {
    const auto [sub, command] = program.command<ListCommand>(everyday, name, summary, act);
    sub.option(argument, command.name, description);
    sub.option("--json", command.json, "Print JSON");
    add_outside_options(sub, command.outside, OutsideCodeFrom::plugins);
}

}  // namespace

void add_list(ProgramDefinition& program) {
    add_listing(program, "list", "List samplers, estimators, scenes, studies and so on", list, "KIND",
                listed_kinds_in_words());
}

void add_explain(ProgramDefinition& program) {
    add_listing(program, "explain", "Explain a sampler, estimator, scene or term: what it is, its source, its limits",
                explain, "NAME", "A name that 'list' shows, a term of the glossary, or a scene file");
}

}  // namespace ff::app
