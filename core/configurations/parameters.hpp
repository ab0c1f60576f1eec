#pragma once

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <utility>

namespace ff {

/// In the precision that the exact values of configurations are computed in.
inline constexpr long double pi = std::numbers::pi_v<long double>;

/// @param parameters  as the documentation of a configuration's formula names them
/// @throws UserError where one is not a positive, finite number
inline void expect_positive(std::string_view configuration,
                            std::initializer_list<std::pair<std::string_view, long double>> parameters) {
    for (const auto& [name, value] : parameters) {
        if (std::isfinite(value) && value > 0) continue;
        throw UserError(
            fmt::format("{}: {} = {:g} (a length or ratio of it has to be positive and finite). Correct it.",
                        configuration, name, value));
    }
}

/// @throws UserError "CONFIGURATION: PROBLEM" unless `holds`
inline void expect_valid(bool holds, std::string_view configuration, std::string_view problem) {
    if (!holds) throw UserError(fmt::format("{}: {}", configuration, problem));
}

}  // namespace ff
