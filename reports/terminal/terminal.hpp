#pragma once

#include "reports/text/colour.hpp"
#include "studies/plan/plan.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// The result in a dozen lines: a row for each method and size, then what the publication comes to.
std::string terminal_summary(const studies::StudyResults& results, Colour colour = Colour::none);

/// What a run would do: units, trials, evaluations and expected time.
std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads);

}  // namespace ff::reports
