#pragma once

#include "reports/templates/templates.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// report.html: one file that needs no network: the verdict, the published tables beside ours, pictures, and what it
/// takes to reproduce it. Made from report.mustache, report.css, report.js, vega.js. Byte-identical for the same store
/// and templates.
std::string html_report(const studies::StudyResults& results, const Templates& templates);

}  // namespace ff::reports
