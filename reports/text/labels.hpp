#pragma once

#include "studies/analysis/slopes.hpp"
#include "studies/comparison/decisions.hpp"
#include "studies/store/store.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// Label of a face (number from 1) as its scene gives it; "sum" and "sum_re" for the to-face of sums.
std::string from_label(const Scene& scene, const studies::Quantity& quantity);
std::string to_label(const Scene& scene, const studies::Quantity& quantity);

/// The quantity as people write it: "F 1-6", "Σ 3", "Σ r.e.".
std::string quantity_label(const Scene& scene, const studies::Quantity& quantity);

/// The size of a cell: "169 × 625 rays", "36 × 5×5 nodes", "1".
std::string size_label(const studies::StudyPlan& plan, const studies::Cell& cell);

/// Smallest and largest size of a ladder, and the number of sizes: "64 … 65536 (11)".
std::string sizes_text(const studies::StudyPlan& plan, const studies::Ladder& ladder);

/// "-0.66±0.02", half the width of studies::interval_with_misfit; "-0.25" without one; "-" without a slope.
std::string slope_text(const studies::Slope& slope);

/// Method and size; the scene too where the study has several.
std::string cell_label(const studies::StudyPlan& plan, const studies::Cell& cell);

/// "NAME: " as a prefix for results of one scene; empty where the study has no other.
std::string scene_prefix(const studies::StudyPlan& plan, std::size_t scene);

/// The method; the scene too where the study has several.
std::string method_label(const studies::StudyPlan& plan, const studies::Cell& cell);

/// " of NAME" as a suffix for results of one scene; empty where the study has no other.
std::string of_scene(const studies::StudyPlan& plan, std::size_t scene);

/// "a, b and c"; with more than `most` names, the first ones and the number of others. Names with commas, "and" or "or"
/// are quoted.
std::string listed(std::vector<std::string> names, std::size_t most = 4, std::string_view conjunction = "and");

/// What methods are compared at: "at 4096 evaluations", "in 0.02 s of processor time", "at an RMSE of 0.001".
std::string budget_label(studies::Equal equal, double budget);

/// "adjacent", "adjacent, maybe occluded"
std::string_view kind_in_words(studies::PairKind kind);

/// The pairs of classes in words: "on parallel pairs", "on parallel and adjacent pairs of cube".
std::string on_pairs(const studies::StudyPlan& plan, std::size_t scene, std::string_view classes);

/// The same as the first words of a sentence, with a comma where they end with the name of a scene.
std::string begin_on_pairs(const studies::StudyPlan& plan, std::size_t scene, std::string_view classes);

/// The same as a heading: "adjacent pairs", "cube: adjacent pairs".
std::string heading_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class);

/// The program that completed a study: version and revision. Empty before that. What differs between runs of one
/// program (host, date, seconds) is in context.json only.
std::string program_label(const studies::Context& context);

}  // namespace ff::reports
