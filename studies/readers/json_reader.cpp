#include "studies/readers/json_reader.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ff::studies {

using Kind = JsonValue::Kind;

void JsonReader::fail(const JsonValue& at, const std::string& message) const {
    throw UserError(describe(origin_, at.position) + message);
}

void JsonReader::expect_object(const JsonValue& value, std::string_view what,
                               std::initializer_list<std::string_view> keys) const {
    if (value.kind != Kind::object)
        fail(value, fmt::format("{} is not an object. Write {{\"key\": value, ...}}.", what));
    for (std::size_t k = 0; k < value.keys.size(); ++k) {
        const std::string& key = value.keys[k];
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        const std::vector<std::string_view> known(keys);
        const std::string nearest = nearest_name(key, known);
        fail(value.items[k],
             fmt::format("unknown key \"{}\" in {} (it would be ignored silently). {}", excerpt(key), what,
                         nearest.empty() ? fmt::format("Known keys: {}.", fmt::join(known, ", "))
                                         : fmt::format("Did you mean \"{}\"?", nearest)));
    }
}

const JsonValue& JsonReader::member(const JsonValue& object, std::string_view key, std::string_view what) const {
    const JsonValue* found = object.find(key);
    if (found == nullptr) fail(object, fmt::format("{} has no \"{}\". Add it.", what, key));
    return *found;
}

const std::vector<JsonValue>& JsonReader::array(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::array) fail(value, fmt::format("\"{}\" is not a list. Write [..., ...].", key));
    return value.items;
}

std::string JsonReader::text(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::string) fail(value, fmt::format("\"{}\" is not a text. Put it in double quotes.", key));
    if (const auto problem = problem_with_title(value.text); !problem.empty())
        fail(value, fmt::format("\"{}\" {}", excerpt(value.text), problem));
    return value.text;
}

std::string JsonReader::optional_text(const JsonValue& object, std::string_view key) const {
    const JsonValue* found = object.find(key);
    return found == nullptr ? std::string{} : text(*found, key);
}

std::uint64_t JsonReader::count(const JsonValue& value, std::string_view key, double largest) const {
    if (value.kind != Kind::number || value.number < 1 || value.number > largest ||
        std::floor(value.number) != value.number) {
        fail(value, fmt::format("\"{}\" is not a whole number from 1 to {:.0f}. Write it like 169.", key, largest));
    }
    return static_cast<std::uint64_t>(value.number);
}

bool JsonReader::flag(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::boolean)
        fail(value, fmt::format("\"{}\" is neither true nor false. Write one of them, without quotes.", key));
    return value.number != 0;
}

std::size_t JsonReader::choice(const JsonValue& value, std::string_view key,
                               std::initializer_list<std::string_view> words) const {
    const std::string word = text(value, key);
    const auto* const found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::vector<std::string_view> known(words);
    fail(value, fmt::format("\"{}\" is no {}. {}Known: {}.", excerpt(word), key, did_you_mean(word, known, '"'),
                            fmt::join(known, ", ")));
}

std::string JsonReader::number_as_printed(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::string) {
        fail(value, fmt::format("\"{}\" must be given as a string (a JSON number loses trailing zeros). "
                                "Put the digits in double quotes, exactly as printed.",
                                key));
    }
    const std::string& digits = value.text;
    const bool plain = digits.find_first_not_of("0123456789.") == std::string::npos &&
                       std::count(digits.begin(), digits.end(), '.') <= 1 && digits.size() <= 16 &&
                       digits.find_first_of("0123456789") != std::string::npos;
    if (!plain) {
        fail(value, fmt::format("\"{}\" is not a printed number (digits and at most one decimal point, 16 "
                                "characters at most). Write null for a blank cell.",
                                excerpt(digits)));
    }
    return digits;
}

}  // namespace ff::studies
