#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Records of results.json and of summary.csv; docs/results.md has their keys.
Json cell_json(const studies::StudyPlan& plan, const studies::CellAnalysis& found);
Json summary_json(const Scene& scene, const studies::Summary& s);

/// The record after what tells a cell: study, scene, method, patches_per_face, samples_per_patch (null for none),
/// level.
Json in_cell(const studies::StudyPlan& plan, std::size_t cell, const Json& record);

}  // namespace ff::reports
