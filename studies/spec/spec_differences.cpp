#include "studies/spec/spec_differences.hpp"

#include "core/support/words.hpp"

#include <algorithm>
#include <utility>

namespace ff::studies {
namespace {

using KeyValues = std::vector<std::pair<std::string, std::string>>;

/// The "key = value" lines of a study file.
KeyValues keys_of(std::string_view text) {
    KeyValues keys;
    for_each_line(text, [&](std::uint64_t, std::string_view line) {
        const auto equals = line.find(" = ");
        if (equals != std::string_view::npos) keys.emplace_back(line.substr(0, equals), line.substr(equals + 3));
    });
    return keys;
}

std::string value_of(const KeyValues& keys, const std::string& key) {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& each) { return each.first == key; });
    return found == keys.end() ? std::string() : found->second;
}

void compare(const std::string& place, const KeyValues& first, const KeyValues& second,
             std::vector<SpecDifference>& out) {
    for (const auto& [key, value] : first) {
        if (value_of(second, key) != value) out.push_back({place, key, value, value_of(second, key)});
    }
    for (const auto& [key, value] : second) {
        if (value_of(first, key).empty()) out.push_back({place, key, "", value});
    }
}

KeyValues keys_of_study(StudySpec spec) {
    spec.methods.clear();
    return keys_of(to_toml(spec));
}

KeyValues keys_of_method(const Method& method) {
    StudySpec spec;
    spec.methods = {method};
    spec.methods.front().sizes.clear();
    const std::string text = to_toml(spec);
    return keys_of(text.substr(text.find("[[method]]")));
}

}  // namespace

std::vector<SpecDifference> differences_of(const StudySpec& first, const StudySpec& second) {
    std::vector<SpecDifference> out;
    compare("study", keys_of_study(first), keys_of_study(second), out);
    for (const Method& method : first.methods) {
        const auto other = std::find_if(second.methods.begin(), second.methods.end(),
                                        [&](const Method& each) { return each.name == method.name; });
        if (other != second.methods.end()) compare(method.name, keys_of_method(method), keys_of_method(*other), out);
    }
    return out;
}

}  // namespace ff::studies
