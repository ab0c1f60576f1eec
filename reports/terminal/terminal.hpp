#pragma once

#include "reports/text/text_style.hpp"
#include "studies/plan/plan.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// The result in a dozen lines: a row for each method and size, then the verdict on the publication.
std::string terminal_summary(const studies::StudyResults& results, const TextStyle& style = {});

/// A run's work in advance: units, trials, evaluations and expected time.
std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads, const TextStyle& style = {});

}  // namespace ff::reports
