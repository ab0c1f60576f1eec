#include "app/commands.hpp"

#include "app/result_files.hpp"
#include "app/study_files.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "samplers/sampler.hpp"
#include "studies/controls.hpp"
#include "studies/descriptions.hpp"
#include "studies/selftest/selftest.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace ff::app {
namespace {

void print_row(std::string_view name, std::string_view summary) {
    fmt::print("{:<16} {}\n", name, summary);
}

void print_all(std::span<const studies::Description> descriptions) {
    for (const auto& description : descriptions) print_row(description.name, description.summary);
}

constexpr std::array<std::string_view, 6> kinds{"samplers", "estimators", "scenes", "studies", "formats", "controls"};

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

}  // namespace

ExitCode list(const std::string& kind) {
    if (kind == "samplers") {
        for (const auto& entry : samplers::catalogue()) print_row(entry.info.name, entry.info.summary);
    } else if (kind == "estimators") {
        print_all(studies::estimator_descriptions());
    } else if (kind == "scenes") {
        print_all(studies::scene_descriptions());
    } else if (kind == "studies") {
        for (const auto& study : built_in_studies()) print_row(study.name, study.title);
        print_row(studies::selftest_description.name, studies::selftest_description.summary);
    } else if (kind == "formats") {
        for (const Format& format : all_formats()) print_row(format.name, format.files);
    } else if (kind == "controls") {
        for (const auto& control : studies::controls())
            fmt::print("{:<22} {:<12} {}\n", control.description.name, control.kind, control.description.summary);
    } else {
        throw UserError(fmt::format("'{}' cannot be listed. {}Known: {}.", kind, did_you_mean(kind, kinds),
                                    fmt::join(kinds, ", ")));
    }
    return ExitCode::passed;
}

ExitCode explain(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& entry : samplers::catalogue()) {
        names.emplace_back(entry.info.name);
        if (entry.info.name != name) continue;
        print_description("sampler", name, entry.info.summary, entry.info.details, entry.info.reference);
        fmt::print("Sizes:  {}{}\n", sizes_in_words(entry.info), beside_its_sizes(entry.info.sizes));
        return ExitCode::passed;
    }
    for (const auto& [kind, descriptions] :
         {std::pair("estimator", studies::estimator_descriptions()), std::pair("scene", studies::scene_descriptions()),
          std::pair("study", std::span(&studies::selftest_description, 1))}) {
        for (const auto& description : descriptions) {
            names.emplace_back(description.name);
            if (description.name != name) continue;
            print_description(kind, name, description.summary, description.details, description.reference);
            return ExitCode::passed;
        }
    }
    for (const auto& control : studies::controls()) {
        const auto& [control_name, summary, details, reference] = control.description;
        if (control_name != name) continue;
        print_description(fmt::format("control {}, broken on purpose", control.kind), name, summary, details,
                          reference);
        return ExitCode::passed;
    }
    for (const auto& study : built_in_studies()) {
        names.push_back(study.name);
        if (study.name != name) continue;
        print_description("study", name, study.title,
                          fmt::format("{}\n{}", study.file.string(), studies::to_toml(studies::load_study(study.file))),
                          "");
        return ExitCode::passed;
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UserError(fmt::format("'{}' is unknown. {}See 'ffstudy list samplers', 'estimators', 'scenes' and 'studies'.",
                                name, did_you_mean(name, known)));
}

}  // namespace ff::app
