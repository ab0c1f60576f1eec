#pragma once

#include "studies/readers/names.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace ff::studies {

/// The goal of an adaptive study.
enum class StoppingGoal {
    rmse,  ///< root mean squared error of the mean over all trials, on every pair
    ci,    ///< half-width of the interval of the bias, at the study's level, for each pair individually
};
template <>
inline constexpr auto names_of<StoppingGoal> = name_table(Named{StoppingGoal::rmse, "rmse"},
                                                          Named{StoppingGoal::ci, "ci"});

/// When a cell has enough trials: Stein's two stages (stats/means/mean_interval.hpp). The spread of the pilot's trials
/// determines the total number, at most the study's `trials`.
struct StoppingRule {
    StoppingGoal goal = StoppingGoal::rmse;
    double target = 0;         ///< in units of the form factor, > 0
    std::uint64_t pilot = 30;  ///< trials of the first round, at least `fewest_pilot_trials`
    auto operator<=>(const StoppingRule&) const = default;
};

/// With fewer trials, the pilot's spread tells too little, and no mean squared error could be promised.
inline constexpr std::uint64_t fewest_pilot_trials = 5;

class TomlReader;

/// [until] of a study file. @param trials  the study's, which bound the pilot
/// @throws UserError
StoppingRule read_stopping_rule(const TomlReader& reader, std::uint64_t trials);

/// "rmse=1e-5" or "ci=1e-5". @throws UserError
StoppingRule parse_stopping_rule(std::string_view text);

/// The section of a study file.
std::string to_toml(const StoppingRule& rule);

}  // namespace ff::studies
