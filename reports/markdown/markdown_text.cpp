#include "reports/markdown/markdown_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::reports {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether a character belongs to a word: an underscore between two such characters is not markup. Letters beyond ASCII
/// belong to words.
bool in_word(char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a character means something to Markdown between these neighbours; 0 stands for none.
bool is_markup(char before, char c, char after) {
    switch (c) {
        case '\\':
        case '`':
        case '*':
        case '~':
            return true;
        case '_':
            return !in_word(before) || !in_word(after);
        case '<':  // of a tag, a comment or a link
            return is_letter(after) || after == '/' || after == '!' || after == '?';
        case '&':  // of an entity
            return is_letter(after) || after == '#';
        case ']':  // of a link: intervals are in brackets as well
            return after == '(';
        default:
            return false;
    }
}

}  // namespace

std::string markdown_text(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char before = i == 0 ? '\0' : text[i - 1];
        const char after = i + 1 == text.size() ? '\0' : text[i + 1];
        if (is_markup(before, text[i], after)) out += '\\';
        out += text[i];
    }
    return out;
}

std::string markdown_cell(std::string_view text) {
    std::string out;
    for (const char c : markdown_text(text)) out += c == '|' ? "\\|" : std::string(1, c);
    return out;
}

std::string markdown_code(std::string_view language, std::string_view lines) {
    std::string fence = "```";
    while (lines.find(fence) != std::string_view::npos) fence += '`';
    return fmt::format("{}{}\n{}{}\n", fence, language, lines, fence);
}

}  // namespace ff::reports
