#include "studies/spec/estimator_keys.hpp"

#include "core/estimators/added.hpp"
#include "core/support/error.hpp"
#include "studies/outside/program.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {
namespace {

struct Key {
    std::string_view name;
    bool (*is_of)(const EstimatorInfo& estimator);
};

constexpr std::array estimator_keys{
    Key{"allocation", [](const EstimatorInfo& estimator) { return estimator.has_allocation(); }},
    Key{"tracer", [](const EstimatorInfo& estimator) { return estimator.has_tracer; }},
    Key{"map", [](const EstimatorInfo& estimator) { return estimator.has_map; }},
};

/// The estimator that a program is, where it has been admitted.
const EstimatorInfo& find_admitted(const TomlReader& reader, const std::string& command) {
    try {
        const auto folder = std::filesystem::path(reader.origin()).parent_path();
        if (const auto* added = find_added_estimator(full_command_name(command, folder))) return added->entry().info;
    } catch (const UserError& error) {
        reader.fail("estimator", fmt::format("is refused: {}", error.what()));
    }
    reader.fail("estimator",
                "is refused: the program has not been admitted (reading a study runs nothing). Admit it first, see "
                "studies/outside/outside_code.hpp.");
}

}  // namespace

const EstimatorInfo& read_estimator(const TomlReader& reader) {
    const std::string name = reader.optional_text("estimator").value_or("");
    if (const auto* added = find_added_estimator(name)) return added->entry().info;
    if (names_command(name)) return find_admitted(reader, name);
    std::vector<std::string_view> names;
    for (const EstimatorEntry& estimator : estimators()) names.push_back(estimator.info.name);
    return estimators()[reader.index_of("estimator", names)].info;
}

void refuse_keys_of_others(const TomlReader& reader, const EstimatorInfo& estimator) {
    for (const Key& key : estimator_keys) {
        if (!reader.has(key.name) || key.is_of(estimator)) continue;
        std::vector<std::string_view> names;
        for (const EstimatorEntry& other : estimators()) {
            if (key.is_of(other.info)) names.push_back(other.info.name);
        }
        const std::string_view last = names.back();
        names.pop_back();
        const std::string all =
            names.empty() ? fmt::format("{} has", last) : fmt::format("{} and {} have", fmt::join(names, ", "), last);
        reader.fail(key.name, fmt::format("(only {} it). Remove the key.", all));
    }
}

}  // namespace ff::studies
