#include "core/support/excerpt.hpp"

#include <cstddef>

namespace ff {

std::string excerpt(std::string_view text) {
    constexpr std::size_t most = 200;
    if (text.size() <= most) return std::string(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // inside a UTF-8 character
    return std::string(text.substr(0, end)) + "…";
}

}  // namespace ff
