#include "studies/scene_files/energyplus/input_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

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

std::string Object::small_text(std::string_view field) const {
    return in_small_letters(text(field));
}

void fail_at(std::string_view file, std::uint64_t line, std::string_view problem) {
    throw UserError(fmt::format("{}:{}: {}", file, line, problem));
}

double number_of_field(std::string_view file, const Field& field, std::string_view what) {
    const auto value = finite_number(field.text);
    if (!value)
        fail_at(file, field.line,
                fmt::format("{} is {}, not a finite number. Correct it.", what,
                            field.text.empty() ? "blank" : fmt::format("'{}'", excerpt(field.text))));
    return *value;
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
