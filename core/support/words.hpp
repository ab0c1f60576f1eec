#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// The text without leading and trailing blanks and line ends.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

inline std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

inline std::string in_capitals(std::string_view text) {
    std::string capitals(text);
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return capitals;
}

/// Words between blanks, or between whatever separates them; none is empty.
inline std::vector<std::string_view> split_words(std::string_view line, std::string_view separators = " \t\r") {
    std::vector<std::string_view> words;
    for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
        const std::size_t end = line.find_first_of(separators, begin);
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(separators, end);
    }
    return words;
}

/// The parts before, between and after separators; of a text without any, the text.
inline std::vector<std::string_view> split_at(char separator, std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    parts.push_back(text);
    return parts;
}

/// Calls visit(number from 1, line without its end) for every line.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
    std::uint64_t number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        visit(++number, text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
}

/// The whole text as a number, without a plus sign; empty where it is not one.
template <class Number>
std::optional<Number> parse_bare_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The same, with a plus sign or without.
template <class Number>
std::optional<Number> parse_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    return parse_bare_number<Number>(word);
}

inline std::optional<double> finite_number(std::string_view word) {
    const auto value = parse_number<double>(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace ff
