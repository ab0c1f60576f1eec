#include "studies/verdicts/known_law.hpp"

#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "stats/distributions.hpp"
#include "studies/readers/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff::studies {

template <>
inline constexpr auto names_of<KnownLaw::Family> = [] {
    using enum KnownLaw::Family;
    return name_table(Named{uniform, "uniform"}, Named{normal, "normal"}, Named{exponential, "exponential"});
}();

namespace {

using Family = KnownLaw::Family;

constexpr std::array<std::string_view, 3> examples{"uniform(0, 1)", "normal(0, 1)", "exponential(1)"};

/// What stands between the brackets; empty where something is no finite number.
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
    const auto family = value_named<Family>(name);
    if (!family) {
        problem = fmt::format("(no known distribution). {}There are {}.", did_you_mean(name, suggested_names<Family>()),
                              fmt::join(examples, ", "));
        return std::nullopt;
    }
    const std::string_view example = examples.at(static_cast<std::size_t>(*family));
    const bool closed = open != std::string_view::npos && text.ends_with(')');
    const auto numbers = closed ? numbers_of(text.substr(open + 1, text.size() - open - 2)) : std::vector<double>();
    if (numbers.size() != (*family == Family::exponential ? 1 : 2)) {
        problem = fmt::format(
            "(its parameters have to be given: fitted to the values that are tested they change the critical values). "
            "Write numbers, as \"{}\".",
            example);
        return std::nullopt;
    }
    KnownLaw law{*family, numbers[0], numbers.size() > 1 ? numbers[1] : 1};
    const double width = family == Family::uniform  ? law.second - law.first
                         : family == Family::normal ? law.second
                                                    : law.first;
    if (!(width > 0)) {
        problem = fmt::format("(a distribution without width). Write it as \"{}\".", example);
        return std::nullopt;
    }
    return law;
}

}  // namespace ff::studies
