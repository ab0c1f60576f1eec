#include "studies/outside/outside_code.hpp"

#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/toml_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace ff::studies {

std::vector<OutsideCode> outside_code(std::string_view text, std::string_view origin) {
    const toml::table root = parse_toml(text, origin);
    const TomlReader file(root, origin);
    std::vector<OutsideCode> all;
    const auto add = [&](OutsideCode code) {
        const bool known = std::any_of(all.begin(), all.end(), [&](const OutsideCode& other) {
            return other.kind == code.kind && other.text == code.text;
        });
        if (!known) all.push_back(std::move(code));
    };
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> files{{{"study", "method"},  //
                                                                                  {"gates", "gate"}}};
    for (const auto& [options, methods] : files) {
        const auto table = file.optional_table(options);
        if (table && table->has("plugins")) {
            for (std::string& path : table->texts("plugins"))
                add({OutsideCode::Kind::plugin, std::move(path), table->place("plugins")});
        }
        for (const TomlReader& method : file.tables(methods)) {
            for (const auto& [key, kind] :
                 {std::pair<std::string_view, OutsideCode::Kind>{"sampler", OutsideCode::Kind::sampler},
                  {"estimator", OutsideCode::Kind::estimator}}) {
                const auto name = method.optional_text(key);
                if (name && names_command(*name)) add({kind, *name, method.place(key)});
            }
        }
    }
    return all;
}

void admit(const OutsideCode& code, const std::filesystem::path& folder, double deadline) {
    switch (code.kind) {
        case OutsideCode::Kind::plugin:
            load_plugin(code.text, folder);
            break;
        case OutsideCode::Kind::sampler:
            load_command_sampler(code.text, folder, deadline);
            break;
        case OutsideCode::Kind::estimator:
            load_command_estimator(code.text, folder, deadline);
            break;
    }
}

const samplers::CatalogueEntry& sampler_of_user(std::string_view name, double deadline) {
    if (names_point_file(name)) return load_point_file(name, "", {});
    if (names_command(name)) return load_command_sampler(name, {}, deadline);
    return samplers::find(name);
}

}  // namespace ff::studies
