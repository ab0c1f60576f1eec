#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/readers/names.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

class TomlReader;

/// [radiosity] of a study file: the systems to solve with the form factors of every trial.
struct RadiosityRequest {
    /// Settings, each solved for separately: one number for all faces, or one for each face of the scene; 0, or
    /// from 1e-30 to 1 - 1e-9.
    std::vector<std::vector<double>> reflectance{{0.1}, {0.5}, {0.9}, {0.99}, {0.999}};
    /// Emitted exitance: one number for all faces, or one for each; 0, or from 1e-30 to 1e30; not all 0. Empty: 1 on
    /// the last face.
    std::vector<double> emission;
    double tolerance = 1e-6;           ///< largest residual of the solvers, relative to the largest emission; in (0, 1)
    std::uint64_t solver_trials = 10;  ///< largest number of trials of a cell that the solvers are run on
    std::uint64_t patch_trials = 0;    ///< largest number of trials of a cell that also give systems between patches
    auto operator<=>(const RadiosityRequest&) const = default;
};

/// @throws UserError
RadiosityRequest read_radiosity(const TomlReader& reader);

/// The section as text of a study file.
std::string to_toml(const RadiosityRequest& request);

/// Numbers separated by commas, of the command line; `option` names it in messages. @throws UserError
std::vector<double> parse_numbers(const std::string& text, const std::string& option);
/// The checks of `read_radiosity`, for values of the command line. @throws UserError that begins with `place`
void check_radiosity(const RadiosityRequest& request, const std::string& place);

/// @throws UserError unless the scene is closed, has exact form factors, and as many faces as the settings
void expect_fitting(const RadiosityRequest& request, const Scene& scene);

/// "0.9"; "0.2, 0.5, 0.5" for one per face.
std::string in_words(const std::vector<double>& reflectance);

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
    double target = 0;         ///< RMSE or half-width to reach, in units of the form factor, > 0
    std::uint64_t pilot = 30;  ///< trials of the first round, at least `fewest_pilot_trials`
    auto operator<=>(const StoppingRule&) const = default;
};

/// The spread of a shorter pilot tells too little, and no mean squared error could be promised.
inline constexpr std::uint64_t fewest_pilot_trials = 5;

/// [until] of a study file. @param trials  the study's, which bound the pilot
/// @throws UserError
StoppingRule read_stopping_rule(const TomlReader& reader, std::uint64_t trials);

/// "rmse=1e-5" or "ci=1e-5". @throws UserError
StoppingRule parse_stopping_rule(std::string_view text);

/// The section of a study file.
std::string to_toml(const StoppingRule& rule);

}  // namespace ff::studies
