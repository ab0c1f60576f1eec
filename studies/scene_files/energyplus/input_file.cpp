#include "studies/scene_files/energyplus/input_file.hpp"

#include <algorithm>
#include <cctype>

namespace ff::studies::energyplus {

const std::string& Object::text(std::string_view field) const {
    static const std::string none;
    const auto found = fields.find(field);
    return found == fields.end() ? none : found->second.text;
}

std::uint64_t Object::line_of(std::string_view field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? line : found->second.line;
}

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
    return small;
}

const Class* class_named(std::string_view name) {
    const auto* const found =
        std::find_if(classes.begin(), classes.end(),
                     [small = in_small_letters(name)](const Class& one) { return one.name == small; });
    return found == classes.end() ? nullptr : found;
}

}  // namespace ff::studies::energyplus
