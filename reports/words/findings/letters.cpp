#include "reports/words/findings/letters.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {

using studies::Ranked;

std::string letter(std::span<const Ranked> ranked, const Ranked& one) {
    const bool groups = std::any_of(ranked.begin(), ranked.end(), [](const Ranked& each) { return each.group > 0; });
    return groups ? std::string(1, static_cast<char>('a' + std::min<std::size_t>(one.group, 25))) : std::string();
}

std::string letters_in_words(double level, std::size_t blocks) {
    return fmt::format(
        "Methods with the same letter are not shown to differ from the first of them ({:g} % over all pairs of "
        "methods{}). Errors rarer than the trials can show could change this.",
        100 * (1 - level), blocks > 1 ? " in all blocks" : "");
}

}  // namespace ff::reports
