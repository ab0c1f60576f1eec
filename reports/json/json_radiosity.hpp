#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Records of results.json and of the tables of a study with radiosity; docs/results.md has their keys.
Json exact_json(const studies::StudyPlan& plan, const studies::radiosity::ExactSystem& system);
Json consequences_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& found);
Json setting_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                  const studies::radiosity::SettingStatistics& at);
Json exitance_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                   const studies::radiosity::ExitanceStatistics& found);
Json solver_json(const studies::radiosity::SolverStatistics& found);

/// The object at `radiosity`, or null; docs/results.md has its keys.
Json radiosity_json(const studies::StudyResults& results);

}  // namespace ff::reports
