#pragma once

#include "reports/text/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Records of results.json and of the tables in CSV; docs/results.md has their keys.
Json cell_json(const studies::StudyPlan& plan, const studies::CellAnalysis& found);
Json summary_json(const Scene& scene, const studies::Summary& s);
Json slope_json(const Scene& scene, const studies::Slope& slope);
Json exact_json(const studies::StudyPlan& plan, const studies::radiosity::ExactSystem& system);
Json consequences_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& found);
Json setting_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                  const studies::radiosity::SettingStatistics& at);
Json exitance_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                   const studies::radiosity::ExitanceStatistics& found);
Json solver_json(const studies::radiosity::SolverStatistics& found);

/// Samples per patch; null for none.
Json samples_json(const studies::Cell& cell);

/// The record, preceded by the keys that identify a cell: study, scene, method, patches_per_face, samples_per_patch,
/// level.
Json in_cell(const studies::StudyPlan& plan, std::size_t cell, const Json& record);

/// Whether values that rest on measured times, which differ from run to run, are shown, or the others.
enum class Timed { no, yes };

/// The records at these keys of results.json; null where the study has none.
Json until_json(const studies::StudyResults& results);
Json heavy_tails_json(const studies::StudyResults& results);
Json coverage_json(const studies::StudyResults& results);
Json reductions_json(const studies::StudyResults& results);
/// Contests at equal processor time, or those at equal evaluations and at equal error.
Json contests_json(const studies::StudyResults& results, Timed timed);
Json claimed_errors_json(const studies::StudyResults& results);
Json slopes_json(const studies::StudyResults& results);
Json radiosity_json(const studies::StudyResults& results);

}  // namespace ff::reports
