#include "app/commands/commands.hpp"

#include "app/command_line/listings.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/study_files.hpp"
#include "app/terminal/messages.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "reports/text/scene_text.hpp"
#include "samplers/sampler.hpp"
#include "studies/explain/controls.hpp"
#include "studies/explain/descriptions.hpp"
#include "studies/explain/scene_explanation.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/selftest/selftest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {
namespace {

void print_description(std::string_view kind, std::string_view name, std::string_view summary, std::string_view details,
                       std::string_view reference) {
    fmt::print("{} ({})\n{}\n\n{}\n", name, kind, summary, details);
    if (!reference.empty()) fmt::print("\nSource: [{}], see docs/references.md\n", reference);
}

std::string_view beside_its_sizes(samplers::Sizes sizes) {
    switch (sizes) {
        case samplers::Sizes::powers:
            return "; others lose the net property";
        case samplers::Sizes::fourth_power:
            return " only (k^2 for points on one patch)";
        case samplers::Sizes::any:
        case samplers::Sizes::nodes:
            break;
    }
    return "";
}

void print_sampler(const samplers::SamplerInfo& info) {
    print_description("sampler", info.name, info.summary, info.details, info.reference);
    fmt::print("Sizes:  {}{}\n", sizes_in_words(info), beside_its_sizes(info.sizes));
    fmt::print("Random: {}\n", info.randomised ? "yes, every trial has points of its own" : "no, one trial says all");
}

void print_configuration(const Configuration& configuration) {
    const std::string_view no_scene = why_no_scene(configuration.kind);
    const std::string scene = no_scene.empty() ? fmt::format("{} (scene), face {} to face {}", configuration.scene_name,
                                                             configuration.from + 1, configuration.to + 1)
                                               : fmt::format("none: {}", no_scene);
    print_description("configuration", configuration.name, configuration.summary,
                      fmt::format("Exact:  {}\nFrom:   {}\nHidden: {}\nScene:  {}", exact_digits(configuration),
                                  configuration.formula,
                                  configuration.occluded ? "in part, something stands in between" : "nothing", scene),
                      configuration.reference);
}

/// Everything that can be explained, but for samplers, configurations and studies, whose descriptions are made.
struct Entry {
    std::string kind;
    studies::Description description;
};

std::vector<Entry> entries() {
    std::vector<Entry> all;
    for (const auto& [kind, plural, descriptions] : studies::all_choices()) {
        for (const auto& description : descriptions) all.push_back({std::string(kind), description});
    }
    all.push_back({"study", studies::selftest_description});
    for (const Format& format : all_formats())
        all.push_back({"format", {format.name, format.files, "What is in them: docs/results.md.", ""}});
    for (const auto& control : studies::controls())
        all.push_back({fmt::format("control {}, broken on purpose", control.kind), control.description});
    return all;
}

/// "box:2x1x0.5" is explained under the name of its pattern.
std::string_view pattern_of(std::string_view name) {
    return name.starts_with("box:") ? "box:AxBxC" : name;
}

/// The scene of that name, built in or in a file; empty where it is neither.
/// @throws UserError where a file, or the measures of a scene, are wrong
std::optional<Scene> find_scene(const std::string& name) {
    if (studies::names_scene_file(name)) {
        const std::filesystem::path file(name);
        return studies::make_scene(
            studies::with_scene_text(name, studies::read_text_file(file, studies::FileKind::scene)));
    }
    const std::string_view family = std::string_view(name).substr(0, name.find(':'));
    const auto scenes = configuration_scene_names();
    const bool known = std::find(scenes.begin(), scenes.end(), family) != scenes.end();
    return known || family == "cube" || (name.starts_with("box:") && name != "box:AxBxC")
               ? std::optional(studies::make_scene(name))
               : std::nullopt;
}

void print_scene(const Scene& scene) {
    fmt::print("{}", reports::scene_text(scene, studies::explain_scene(scene)));
    for (const std::string& doubt : scene.empty_box ? std::vector<std::string>() : studies::doubts_about(scene))
        say("warning: {}\n", doubt);
}

}  // namespace

ExitCode list(const std::string& kind) {
    const auto rows = listed(kind);
    std::size_t width = 0;
    for (const Listed& row : rows) width = std::max(width, row.name.size());
    for (const Listed& row : rows) fmt::print("{:<{}}  {}\n", row.name, width, row.summary);
    return ExitCode::passed;
}

ExitCode explain(const std::string& name) {
    if (studies::names_point_file(name)) {
        print_sampler(studies::load_point_file(name, "", {}).info);
        return ExitCode::passed;
    }
    std::vector<std::string> names;
    for (const auto& entry : samplers::catalogue()) {
        names.emplace_back(entry.info.name);
        if (entry.info.name != name) continue;
        print_sampler(entry.info);
        return ExitCode::passed;
    }
    const auto scene = find_scene(name);
    for (const auto& [kind, description] : entries()) {
        names.emplace_back(description.name);
        if (description.name != pattern_of(name)) continue;
        print_description(kind, description.name, description.summary, description.details, description.reference);
        if (scene) {
            fmt::print("\n");
            print_scene(*scene);
        }
        return ExitCode::passed;
    }
    bool explained = false;
    for (const Configuration& configuration : configurations()) {
        names.emplace_back(configuration.name);
        if (configuration.name != name && configuration.id != name && configuration.scene_name != name) continue;
        if (explained) fmt::print("\n");
        print_configuration(configuration);
        explained = true;
    }
    if (scene) {
        if (explained) fmt::print("\n");
        print_scene(*scene);
        explained = true;
    }
    if (explained) return ExitCode::passed;
    for (const auto& study : built_in_studies()) {
        names.push_back(study.name);
        if (study.name != name) continue;
        print_description("study", name, study.title,
                          fmt::format("{}\n{}", study.file.string(), studies::to_toml(studies::load_study(study.file))),
                          "");
        return ExitCode::passed;
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UserError(fmt::format("'{}' is unknown. {}See 'ffstudy list KIND', with KIND one of: {}.", name,
                                did_you_mean(name, known), listed_kinds_in_words()));
}

}  // namespace ff::app
