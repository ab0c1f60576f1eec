#include "studies/printable.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

std::string_view problem_with_title(std::string_view title) {
    if (std::none_of(title.begin(), title.end(), is_control)) return {};
    return "(line breaks and control characters would break reports). Leave them out.";
}

std::string_view problem_with_name(std::string_view name) {
    if (std::none_of(name.begin(), name.end(), [](char c) { return is_control(c) || c == '|'; })) return {};
    return "(control characters and '|' would break tables). Leave them out.";
}

}  // namespace ff::studies
