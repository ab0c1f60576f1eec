#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// The effect of errors on the exitance, a sentence each; empty where the study has no [radiosity].
std::vector<std::string> radiosity_in_brief(const studies::StudyResults& results);

/// The exitance error of each compared method, at the reflectance of the headline.
struct LightInBrief {
    std::string reflectance;
    std::string clause;  ///< "at reflectance 0.9 the exitance error is 27 % with PDM, 0.90 ± 0.02 % with SR"
    std::string value;   ///< "0.9 % to 27 %"
};
std::optional<LightInBrief> light_in_brief(const studies::StudyResults& results);

/// The compared cells: those of the largest cost that several methods share; else all.
std::vector<std::size_t> lit_cells(const studies::StudyPlan& plan, std::size_t scene);

/// The compared cells of all scenes.
std::vector<std::size_t> all_lit_cells(const studies::StudyPlan& plan);

/// The reflectance of the headline, as an index into the study's: the last that is not above 0.9 on any face.
std::size_t told_setting(const studies::StudyPlan& plan);

/// "0.9", or "0.998 [0.997, 0.999]": the median and the range over trials, where there are several.
std::string over_trials_text(const studies::radiosity::OverTrials& range, std::size_t trials, int digits = 3);

/// An error relative to the exact value: "1.2 %"; rounding shows as "0 %".
std::string percent(double share, int digits = 2);

/// "17.0 ± 1.2 %", of shares; as `percent` where nothing but rounding is left of the half width.
std::string percent_with_half_width(double share, double half);

/// Bias of an exitance relative to the exact one: "-0.3 % ± 0.02 %". Without ± where all trials are equal.
std::string bias_text(const studies::radiosity::ExitanceStatistics& found);

/// Iterations of a solver, or how its runs ended: "12 [11, 13]", "3 converged, 7 too slow".
std::string iterations_text(const studies::radiosity::SolverStatistics& found);

/// RMSE of an exitance that has a mean, relative to the exact one; 0 for a black face without emission.
double relative_error(const studies::radiosity::ExitanceStatistics& found);

/// The face or patch whose exitance has the largest relative error; null where the exitance has no mean.
const studies::radiosity::ExitanceStatistics* worst_element(const studies::radiosity::SettingStatistics& at);

/// A face, or a patch of it: row and column from 1, 0 for the whole face.
struct Place {
    std::string face;
    std::size_t row = 0;
    std::size_t column = 0;
};

/// @param element of ExitanceStatistics, > 0
Place place_of(const Scene& scene, Subdivision subdivision, studies::radiosity::Between between, std::size_t element);

/// "face 3", or "face 3, row 1, column 13".
std::string element_text(const studies::StudyPlan& plan, const studies::radiosity::Consequences& found,
                         std::size_t element);

/// The reflectances of a setting as text: "0.9".
std::string setting_text(const studies::StudyPlan& plan, std::size_t setting);

}  // namespace ff::reports
