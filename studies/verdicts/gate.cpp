#include "studies/verdicts/gate.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"

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

Levels levels_of(const Spec& spec, std::size_t comparisons) {
    FF_EXPECT(comparisons >= 1 && spec.looks >= 1);
    const std::size_t questions = std::max<std::size_t>(1, spec.gates.size()) * spec.looks * comparisons;
    const double shared = stats::bonferroni_level(spec.alpha, questions);
    if (shared < smallest_shared_alpha)
        throw UserError(
            "{}: alpha = {:g} (shared among {} comparisons it is below {:g}, which is not computed). Raise it.",
            spec.name, spec.alpha, questions, smallest_shared_alpha);
    return {.fail_alpha = shared, .pass_alpha = spec.pass_alpha / static_cast<double>(spec.looks), .power = spec.power};
}

Levels levels_at_one_look(Spec spec, std::size_t comparisons) {
    spec.looks = 1;
    return levels_of(spec, comparisons);
}

bool is_binomial(IntervalMethod method) {
    return method == IntervalMethod::wilson || method == IntervalMethod::clopper_pearson ||
           method == IntervalMethod::wald;
}

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

void refuse_gate(const Gate& gate, const std::string& problem) {
    throw UserError("{}: {}", gate.place, problem);
}

void refuse_undecidable(const Gate& gate, std::string_view unit) {
    refuse_gate(
        gate,
        fmt::format("no number of {} can decide (the reference is too uncertain for this band, or the band is far "
                    "below the noise). Widen the band, or find a better reference.",
                    unit));
}

}  // namespace ff::studies::gates
