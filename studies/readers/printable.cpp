#include "studies/readers/printable.hpp"

#include <fmt/format.h>
#include <boost/locale/utf.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace ff::studies {
namespace {

struct CodeRange {
    std::uint32_t first;
    std::uint32_t last;
};
constexpr std::array unprintable{CodeRange{0x00, 0x1f},     CodeRange{0x7f, 0x9f},     CodeRange{0x061c, 0x061c},
                                 CodeRange{0x200e, 0x200f}, CodeRange{0x2028, 0x202e}, CodeRange{0x2066, 0x2069},
                                 CodeRange{0xfeff, 0xfeff}, CodeRange{0xfff9, 0xfffb}, CodeRange{0xe0000, 0xe007f}};

/// A character, or a byte that is not part of one.
struct Character {
    std::string_view bytes;
    std::uint32_t code = 0;
    bool is_utf8 = false;
};

Character first_character(std::string_view text) {
    const auto* at = text.begin();
    const auto code = boost::locale::utf::utf_traits<char>::decode(at, text.end());
    if (code == boost::locale::utf::illegal || code == boost::locale::utf::incomplete)
        return {text.substr(0, 1), static_cast<unsigned char>(text.front()), false};
    return {text.substr(0, static_cast<std::size_t>(at - text.begin())), code, true};
}

/// Position of the first character for which `wanted` is true.
template <class Wanted>
std::size_t find_character(std::string_view text, Wanted wanted) {
    for (std::size_t at = 0; at < text.size();) {
        const Character character = first_character(text.substr(at));
        if (wanted(character)) return at;
        at += character.bytes.size();
    }
    return std::string_view::npos;
}

bool is_printable(const Character& character) {
    return character.is_utf8 && std::none_of(unprintable.begin(), unprintable.end(), [&](const CodeRange& range) {
               return range.first <= character.code && character.code <= range.last;
           });
}

/// Whether a spreadsheet would compute a cell that holds the name, rather than show it. "+x" and "-x wall" are names.
bool is_formula(std::string_view name) {
    constexpr std::string_view signs = "+-";
    if (name.empty()) return false;
    if (name.front() == '=' || name.front() == '@') return true;
    constexpr std::string_view of_formulas = "()!'\"*/^&<>=+,;:{}[]";
    return signs.find(name.front()) != std::string_view::npos &&
           name.find_first_of(of_formulas, 1) != std::string_view::npos;
}

/// Position of the first character that a report cannot contain: a control character, a line or paragraph separator, a
/// mark that changes the writing direction, or bytes that are not UTF-8. npos where there is none.
std::size_t find_unprintable(std::string_view text) {
    return find_character(text, [](const Character& character) { return !is_printable(character); });
}

}  // namespace

std::size_t find_no_utf8(std::string_view text) {
    return find_character(text, [](const Character& character) { return !character.is_utf8; });
}

std::string visible_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (is_printable(character))
            out += character.bytes;
        else if (!character.is_utf8 || character.code < 0x80)
            fmt::format_to(std::back_inserter(out), "\\x{:02x}", character.code);
        else
            fmt::format_to(std::back_inserter(out), "\\u{:04x}", character.code);
        text.remove_prefix(character.bytes.size());
    }
    return out;
}

std::string_view problem_with_title(std::string_view title) {
    if (find_unprintable(title) == std::string_view::npos) return {};
    return "(line breaks, control characters and marks of direction would break reports). Leave them out.";
}

std::string_view problem_with_name(std::string_view name) {
    if (find_unprintable(name) != std::string_view::npos || name.find('|') != std::string_view::npos)
        return "(line breaks, control characters, marks of direction and '|' would break tables). Leave them out.";
    if (is_formula(name)) return "(a spreadsheet would take it for a formula). Begin it with a letter.";
    if (name == "__proto__") return "(the pictures of report.html cannot have it). Rename it.";
    return {};
}

std::string first_names(std::vector<std::string> names, std::size_t most) {
    const std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string toml_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) {
            out += fmt::format("\\u{:04x}", code);
        } else {
            out += c;
        }
    }
    return out + "\"";
}

}  // namespace ff::studies
