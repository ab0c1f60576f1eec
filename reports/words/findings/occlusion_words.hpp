#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// The methods' errors with and without occlusion: a sentence for each method's slopes, then one for each series of
/// scenes with the method of smallest error. Empty without such scenes.
std::vector<std::string> occlusion_in_brief(const studies::StudyResults& results);

/// The same in one clause: in how many scenes each method has the smallest error.
std::string occlusion_clause(const studies::StudyResults& results);

/// Which method to take on partly occluded pairs, and on unoccluded ones. @pre occlusion_clause is not empty
std::string occlusion_advice(const studies::StudyResults& results);

/// A method whose error falls more slowly than that of random points on partly occluded pairs.
struct Slowed {
    std::string method;
    int slow = 0;           ///< partly occluded pairs where it does
    std::size_t pairs = 0;  ///< partly occluded pairs with a slope
};
/// The method of which that is true most often; empty where it is true of none, or of several equally often.
std::optional<Slowed> slowest_where_occluded(const studies::StudyResults& results);

/// The method with the smallest error in one series, by occluded fraction; and after the name of the series.
std::string least_errors_of_series(const studies::StudyResults& results, const studies::OcclusionSeries& series);
std::string series_in_words(const studies::StudyResults& results, const studies::OcclusionSeries& series);

}  // namespace ff::reports
