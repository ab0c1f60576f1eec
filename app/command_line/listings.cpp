#include "app/command_line/listings.hpp"

#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "samplers/outside/added.hpp"
#include "studies/explain/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace ff::app {
namespace {

/// Scenes that study files can name beside those described: families, then those of the catalogue.
void add_scenes(std::vector<Listed>& scenes) {
    for (const SceneFamily& family : scene_families())
        scenes.push_back({fmt::format("{}:{}", family.name, family.of_catalogue),
                          fmt::format("and others: {}, {} to {}", family.measure, family.least, family.most)});
    for (const std::string_view name : configuration_scene_names()) {
        const auto all = configurations();
        const auto first =
            std::find_if(all.begin(), all.end(), [&](const Configuration& c) { return c.scene_name == name; });
        scenes.push_back({std::string(name), std::string(first->summary)});
    }
}

std::vector<std::string_view> plurals() {
    std::vector<std::string_view> names;
    for (const ListedKind& kind : listed_kinds()) names.push_back(kind.plural);
    return names;
}

}  // namespace

std::vector<ListedKind> listed_kinds() {
    std::vector<ListedKind> all{{"sampler", "samplers"}};
    for (const auto& choices : studies::all_choices()) all.push_back({choices.kind, choices.plural});
    all.insert(
        all.end(),
        {{"configuration", "configurations"}, {"study", "studies"}, {"format", "formats"}, {"control", "controls"}});
    return all;
}

std::string listed_kinds_in_words() {
    return fmt::format("{}", fmt::join(plurals(), ", "));
}

std::string names_in_words(std::string_view plural) {
    std::string words;
    for (const Listed& row : listed(plural)) words += (words.empty() ? "" : ", ") + row.name;
    return words;
}

std::string exact_digits(const Configuration& configuration) {
    return fmt::format("{:.15f}", configuration.exact());
}

std::vector<Listed> listed(std::string_view plural) {
    std::vector<Listed> rows;
    const auto add = [&rows](std::string_view name, std::string_view summary) {
        rows.push_back({std::string(name), std::string(summary)});
    };
    for (const auto& choices : studies::all_choices()) {
        if (plural != choices.plural) continue;
        for (const auto& description : choices.descriptions) add(description.name, description.summary);
        if (plural == "scenes") add_scenes(rows);
        return rows;
    }
    if (plural == "samplers") {
        for (const auto& entry : samplers::catalogue()) add(entry.info.name, entry.info.summary);
        for (const auto& [name, sampler] : samplers::added_with_short_names()) add(name, sampler->entry().info.summary);
    } else if (plural == "configurations") {
        for (const Configuration& configuration : configurations())
            add(configuration.name, fmt::format("{} {}", exact_digits(configuration), configuration.summary));
    } else if (plural == "studies") {
        for (const auto& study : built_in_studies()) add(study.name, study.title);
    } else if (plural == "formats") {
        for (const Format& format : all_formats()) add(format.name, format.files);
    } else if (plural == "controls") {
        for (const auto& control : studies::controls())
            add(control.description.name, fmt::format("{:<12} {}", control.kind, control.description.summary));
    } else {
        throw UserError("'{}' cannot be listed. {}Known: {}.", plural, did_you_mean(plural, plurals()),
                        listed_kinds_in_words());
    }
    return rows;
}

std::vector<Listed> listed_for_type(std::string_view type) {
    std::vector<Listed> words;
    for (const ListedKind& kind : listed_kinds()) {
        if (type == "KIND") words.push_back({std::string(kind.plural), fmt::format("list {}", kind.plural)});
        if (type != "NAME" && type != in_capitals(kind.name)) continue;
        std::ranges::move(listed(kind.plural), std::back_inserter(words));
    }
    return words;
}

}  // namespace ff::app
