#include "core/configurations/formulas/parameters.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff {

void expect_positive(std::string_view configuration, std::initializer_list<Parameter> parameters) {
    for (const auto& [name, value] : parameters) {
        if (std::isfinite(value) && value > 0) continue;
        throw UserError(
            fmt::format("{}: {} = {:g} (a length or ratio of it has to be positive and finite). Correct it.",
                        configuration, name, value));
    }
}

void expect_valid(bool holds, std::string_view configuration, std::string_view problem) {
    if (!holds) throw UserError(fmt::format("{}: {}", configuration, problem));
}

}  // namespace ff
