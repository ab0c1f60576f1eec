#include "reports/text/text_style.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string_view code_of(Mark mark) {
    switch (mark) {
        case Mark::good:
            return "\033[32m";
        case Mark::bad:
            return "\033[31m";
        case Mark::open:
            return "\033[33m";
        case Mark::misprint:
        case Mark::surprising:
            return "\033[1m";
        case Mark::none:
            break;
    }
    return "";
}

}  // namespace

std::string painted(const std::string& text, Mark mark, Colour colour) {
    if (colour == Colour::none || mark == Mark::none || text.empty()) return text;
    return fmt::format("{}{}\033[0m", code_of(mark), text);
}

}  // namespace ff::reports
