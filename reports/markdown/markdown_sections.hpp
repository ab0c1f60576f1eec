#pragma once

#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// Sections of report.md, each with its heading; empty where the study has nothing for them.
std::string radiosity_section(const studies::StudyResults& results);
std::string bias_section(const studies::StudyResults& results);
std::string reproduction_section(const studies::StudyResults& results);

}  // namespace ff::reports
