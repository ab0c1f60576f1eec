#include "reports/text/folding.hpp"

#include <algorithm>

namespace ff::reports {
namespace {

/// Where the lines that continue this one begin.
std::size_t hanging_indent(std::string_view line, std::size_t width) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t end_of_name = line.find("  ", blanks);
    if (end_of_name == std::string_view::npos) return blanks;
    const std::size_t text = std::min(line.find_first_not_of(' ', end_of_name), line.size());
    const std::size_t column = visible_length(line.substr(0, text));
    return column <= width / 2 ? column : blanks + 4;
}

}  // namespace

std::size_t visible_length(std::string_view utf8) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        if (utf8[i] == '\033')
            i = std::min(utf8.find('m', i), utf8.size());
        else if ((static_cast<unsigned char>(utf8[i]) & 0xc0) != 0x80)
            ++length;
    }
    return length;
}

std::string folded_line(std::string_view words, std::size_t begin, std::size_t indent, std::size_t width) {
    std::string out;
    std::size_t end = begin;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t word = std::min(words.find_first_not_of(' ', at), words.size());
        const std::size_t after = std::min(words.find(' ', word), words.size());
        const std::size_t blanks = word - at;
        const std::size_t length = visible_length(words.substr(word, after - word));
        if (!out.empty() && end + blanks + length > width) {
            out += '\n' + std::string(indent, ' ');
            end = indent;
        } else {
            out += std::string(blanks, ' ');
            end += blanks;
        }
        out += words.substr(word, after - word);
        end += length;
        at = after;
    }
    return out;
}

std::string folded(std::string_view text, std::size_t width) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        out += visible_length(line) <= width ? std::string(line)
                                             : folded_line(line, 0, hanging_indent(line, width), width);
        if (end < text.size()) out += '\n';
        at = end + 1;
    }
    return out;
}

}  // namespace ff::reports
