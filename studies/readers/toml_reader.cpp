#include "studies/readers/toml_reader.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ff::studies {
namespace {

std::string place_in(std::string_view origin, const toml::source_region& region) {
    return fmt::format("{}:{}:{}", origin, region.begin.line, region.begin.column);
}

std::string shown(const toml::node& node) {
    std::ostringstream out;
    if (node.is_table() || node.is_array_of_tables()) return {};
    node.visit([&](const auto& value) { out << value; });
    return " = " + excerpt(out.str());
}

/// The end of a string that begins at a quote: after its closing quote, or at the end of the line where that is
/// missing.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string of_lines(3, quote);
    const bool has_lines = text.substr(begin).starts_with(of_lines);
    const std::string_view last = has_lines ? std::string_view(of_lines) : text.substr(begin, 1);
    for (std::size_t at = begin + last.size(); at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\') {
            ++at;
        } else if (!has_lines && text[at] == '\n') {
            return at;
        } else if (text.substr(at).starts_with(last)) {
            at += last.size();
            // Quotes may stand before the last three.
            while (has_lines && at < text.size() && text[at] == quote) ++at;
            return at;
        }
    }
    return text.size();
}

/// The parser makes a table of every part of a dotted key, and removes tables in tables by recursion; of values it
/// counts the depth itself.
/// @throws UserError at the first key that has too many parts
void expect_short_keys(std::string_view text, std::string_view origin, std::string_view manual) {
    constexpr std::size_t most_dots = 32;
    constexpr std::string_view around_keys = "=,[]{}\n";
    std::uint64_t line = 1;
    std::size_t dots = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (text[at] == '#') end = std::min(text.find('\n', at), text.size());
        if (text[at] == '"' || text[at] == '\'') end = end_of_string(text, at);
        if (text[at] == '.') ++dots;
        if (around_keys.find(text[at]) != std::string_view::npos) dots = 0;
        if (dots > most_dots) {
            throw UserError("{}:{}: a key of more than {} parts (no table is so deep). See {}.", origin, line,
                            most_dots + 1, manual);
        }
        line += static_cast<std::uint64_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                      text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        at = end;
    }
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view origin, std::string_view manual) {
    expect_short_keys(text, origin, manual);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw UserError("{}: {}. See {}.", place_in(origin, error.source()), error.description(), manual);
    }
}

void TomlReader::expect_only(std::span<const std::string_view> known) const {
    for (const auto& [key, node] : *table_) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        throw UserError("{}: unknown key '{}' (it would be ignored). {}Known: {}.", place_in(origin_, key.source()),
                        excerpt(key.str()), did_you_mean(key.str(), known), fmt::join(known, ", "));
    }
}

std::string TomlReader::place(std::string_view key) const {
    const toml::node* node = find(key);
    return place_in(origin_, node == nullptr ? table_->source() : node->source());
}

void TomlReader::fail(std::string_view key, std::string_view problem) const {
    const toml::node* node = find(key);
    if (node == nullptr) throw UserError("{}: {}: {}", place(key), key, problem);
    throw UserError("{}: {}{} {}", place(key), key, shown(*node), problem);
}

std::optional<std::string> TomlReader::optional_text(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const auto value = node->value_exact<std::string>();
    if (!value || value->empty()) fail(key, "(not a text). Put a text in quotes.");
    return *value;
}

std::string TomlReader::text(std::string_view key) const {
    auto value = optional_text(key);
    if (!value) fail(key, "missing. Add the key with a text in quotes.");
    return *value;
}

std::vector<std::string> TomlReader::texts(std::string_view key) const {
    const toml::node* node = find(key);
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr) return {text(key)};
    std::vector<std::string> values;
    for (const toml::node& item : *list) {
        const auto value = item.value_exact<std::string>();
        if (!value || value->empty()) fail(key, "(expected a list of texts). Put each in quotes.");
        values.push_back(*value);
    }
    if (values.empty()) fail(key, "(an empty list leaves nothing to do). Name at least one.");
    return values;
}

void TomlReader::refuse_name(std::string_view key, std::span<const std::string_view> names) const {
    const auto text = optional_text(key);
    if (!text) fail(key, fmt::format("missing. Choose one of {}.", fmt::join(names, ", ")));
    fail(key, fmt::format("is unknown. {}Known: {}.", did_you_mean(*text, names), fmt::join(names, ", ")));
}

std::size_t TomlReader::index_of(std::string_view key, std::span<const std::string_view> names) const {
    const auto found = std::find(names.begin(), names.end(), optional_text(key).value_or(""));
    if (found == names.end()) refuse_name(key, names);
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::uint64_t> TomlReader::optional_count(std::string_view key) const {
    if (!has(key)) return std::nullopt;
    const auto values = counts(key);
    if (values.size() != 1) fail(key, "(expected one number, not a list). Give one.");
    return values.front();
}

std::uint64_t TomlReader::count(std::string_view key) const {
    const auto value = optional_count(key);
    if (!value) fail(key, "missing. Add the key with a whole number.");
    return *value;
}

std::vector<std::uint64_t> TomlReader::counts(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) fail(key, "missing. Add the key with a whole number or a list of them.");
    std::vector<std::uint64_t> values;
    const auto add = [&](const toml::node& item) {
        const auto value = item.value_exact<std::int64_t>();
        if (!value || *value < 0) fail(key, "(not a whole number from 0 up). Write it like 1000.");
        values.push_back(static_cast<std::uint64_t>(*value));
    };
    if (const toml::array* list = node->as_array()) {
        for (const toml::node& item : *list) add(item);
    } else {
        add(*node);
    }
    if (values.empty()) fail(key, "(an empty list leaves nothing to do). Give at least one number.");
    return values;
}

std::optional<double> TomlReader::optional_number(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const auto value = node->value<double>();
    if (!value || !node->is_number() || !std::isfinite(*value))
        fail(key, "(not a finite number). Write it like 0.5 or 1e-4.");
    return *value;
}

std::vector<double> TomlReader::numbers(std::string_view key) const {
    const toml::node* node = find(key);
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr) {
        const auto number = optional_number(key);
        if (!number) fail(key, "missing. Add the key with a number.");
        return {*number};
    }
    std::vector<double> values;
    for (const toml::node& item : *list) {
        const auto value = item.value<double>();
        if (!value || !item.is_number() || !std::isfinite(*value))
            fail(key, "(expected a list of finite numbers). Write it like [0.9, 1.1].");
        values.push_back(*value);
    }
    if (values.empty()) fail(key, "(an empty list leaves nothing to do). Give at least one number.");
    return values;
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return {};
    const toml::array* list = node->as_array();
    if (list == nullptr) fail(key, fmt::format("(expected a list of tables). Write [[{}]].", key));
    std::vector<TomlReader> readers;
    for (const toml::node& item : *list) {
        const toml::table* table = item.as_table();
        if (table == nullptr) fail(key, "(expected a list of tables). Write each as { key = value }.");
        readers.emplace_back(*table, origin_);
    }
    return readers;
}

std::vector<std::string> TomlReader::keys() const {
    std::vector<std::string> keys;
    for (const auto& [key, node] : *table_) keys.emplace_back(key.str());
    return keys;
}

std::optional<TomlReader> TomlReader::optional_table(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const toml::table* table = node->as_table();
    if (table == nullptr) fail(key, fmt::format("(expected a table). Write [{}].", key));
    return TomlReader(*table, origin_);
}

}  // namespace ff::studies
