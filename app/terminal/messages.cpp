#include "app/terminal/messages.hpp"

#include "studies/readers/printable.hpp"

#include <cstddef>

namespace ff::app {
namespace {

bool verbose = false;

}  // namespace

void be_verbose() {
    verbose = true;
}

bool is_verbose() {
    return verbose;
}

std::string for_message(std::string_view text) {
    constexpr std::size_t most = 2000;
    constexpr std::size_t end = 600;  // a suggestion comes last
    if (text.size() <= most) return studies::visible_text(text);
    const auto within_a_character = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
    };
    std::size_t first = most - end;
    std::size_t last = text.size() - end;
    while (first > 0 && within_a_character(first)) --first;
    while (last < text.size() && within_a_character(last)) ++last;
    return studies::visible_text(text.substr(0, first)) + " … " + studies::visible_text(text.substr(last));
}

}  // namespace ff::app
