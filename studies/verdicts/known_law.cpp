#include "studies/verdicts/known_law.hpp"

#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "stats/basics/distributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff::studies::gates {
namespace {

constexpr std::array<std::string_view, 3> families{"uniform", "normal", "exponential"};
constexpr std::array<std::string_view, 3> examples{"uniform(0, 1)", "normal(0, 1)", "exponential(1)"};
constexpr std::array<std::size_t, 3> parameters{2, 2, 1};

/// The numbers between the brackets; empty where one of them is not a finite number.
std::vector<double> numbers_of(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view part : split_at(',', text)) {
        const auto number = parse_bare_number<double>(trimmed(part));
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace

double cumulative(const KnownLaw& law, double x) {
    switch (law.family) {
        case KnownLaw::Family::uniform:
            return std::clamp((x - law.first) / (law.second - law.first), 0.0, 1.0);
        case KnownLaw::Family::normal:
            return stats::normal_tail((law.first - x) / law.second);
        case KnownLaw::Family::exponential:
            break;
    }
    return x <= 0 ? 0 : -std::expm1(-x / law.first);
}

std::optional<KnownLaw> parse_law(std::string_view text, std::string& problem) {
    const auto open = text.find('(');
    const std::string_view name = trimmed(text.substr(0, open));
    const auto* const found = std::find(families.begin(), families.end(), name);
    if (found == families.end()) {
        problem = fmt::format("(no known distribution). {}There are {}.", did_you_mean(name, families),
                              fmt::join(examples, ", "));
        return std::nullopt;
    }
    const auto family = static_cast<std::size_t>(found - families.begin());
    const bool closed = open != std::string_view::npos && text.ends_with(')');
    const auto numbers = closed ? numbers_of(text.substr(open + 1, text.size() - open - 2)) : std::vector<double>();
    if (numbers.size() != parameters.at(family)) {
        problem = fmt::format(
            "(its parameters have to be given: fitted to the values that are tested they change the critical values). "
            "Write numbers, as \"{}\".",
            examples.at(family));
        return std::nullopt;
    }
    KnownLaw law{static_cast<KnownLaw::Family>(family), numbers[0], numbers.size() > 1 ? numbers[1] : 1};
    const double width = family == 0 ? law.second - law.first : family == 1 ? law.second : law.first;
    if (!(width > 0)) {
        problem = fmt::format("(a distribution without width). Write it as \"{}\".", examples.at(family));
        return std::nullopt;
    }
    return law;
}

}  // namespace ff::studies::gates
